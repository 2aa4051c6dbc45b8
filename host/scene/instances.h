// Instances of a node's mesh, as EXT_mesh_gpu_instancing places them.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "scene/accessor_view.h"

namespace cleave {

// Returns the accessors of instances' transforms.
std::array<gltf::Index, 3> accessorsOf(const gltf::Instancing& instancing);

// Returns whether the node's mesh is placed by instances. It is not where it has a skin, since a skinned mesh is where
// its joints are, nor where the data of its instances is not there.
bool hasInstances(const Scene& scene, const gltf::Node& node);

// Returns how often a node shows its mesh.
size_t instanceCount(const Scene& scene, const gltf::Node& node);

// The transforms of a node's instances to the node; one identity where it has none. The scene outlives this.
class InstanceTransforms {
  public:
    InstanceTransforms(const Scene& scene, const gltf::Node& node);
    size_t count() const { return count_; }
    glm::dmat4 operator[](size_t instance) const;

  private:
    size_t count_;
    std::optional<AccessorValues> translations_;
    std::optional<AccessorValues> rotations_;
    std::optional<AccessorValues> scales_;
};

}  // namespace cleave
