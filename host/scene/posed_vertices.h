// Poses the vertices of a primitive: moved by morph targets, then by a skin or by their node.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/accessor_view.h"
#include "scene/morph_targets.h"
#include "shared/language.h"

namespace cleave {

class PosedVertices {
  public:
    // The primitive has POSITION. `where` names it in messages. Scene and joints outlive this.
    PosedVertices(const Scene& scene, const gltf::Primitive& primitive, const Deformation& deformation,
                  const std::string& where);
    size_t count() const { return positions_.count(); }
    // Returns how many accessors are read for a vertex, which is what it costs.
    size_t terms() const { return 1 + targets_.size() + joints_.size(); }
    // Returns the vertex in the world; `toWorld` counts where it has no joints. Throws Error if it has a joint that the
    // skin does not have.
    vec3 at(size_t vertex, const glm::dmat4& toWorld) const;
    bool hasJoints() const { return !joints_.empty(); }
    // Returns what joints make of the vertex; there are some.
    glm::dmat4 skinMatrix(size_t vertex) const;

  private:
    struct Target {
        AccessorValues deltas;
        double weight;
    };
    struct JointSet {
        AccessorIntegers joints;
        AccessorValues weights;
    };
    const std::vector<glm::dmat4>* matrices_;
    std::string where_;
    AccessorValues positions_;
    std::vector<Target> targets_;   // those whose weight is not 0
    std::vector<JointSet> joints_;  // none: placed by the node
};

// JOINTS_0 and WEIGHTS_0, JOINTS_1 and WEIGHTS_1, ...
struct JointAccessors {
    uint32_t joints = 0;
    uint32_t weights = 0;
};
std::vector<JointAccessors> jointSets(const gltf::Primitive& primitive);

// Returns the accessors that a deformation needs of a primitive, beside its indices.
std::vector<uint32_t> accessorsOf(const gltf::Primitive& primitive, const Deformation& deformation);

}  // namespace cleave
