// Morph targets that move something.
#pragma once

#include <string>
#include <vector>

#include "scene/accessor_view.h"

namespace cleave {

// The way that a node deforms the primitives of its mesh.
struct Deformation {
    const std::vector<double>* weights = nullptr;     // of morph targets; too few of them: the others are 0
    const std::vector<glm::dmat4>* joints = nullptr;  // null: no skin
};

struct MorphTarget {
    uint32_t deltas = 0;  // an accessor
    double weight = 0.0;
};

// Returns the targets that have an attribute of that semantic, and a weight that is not 0.
std::vector<MorphTarget> movingTargets(const gltf::Primitive& primitive, const Deformation& deformation,
                                       const std::string& semantic);

// Returns how many targets the primitives of a node's mesh have.
size_t morphTargetsOf(const Scene& scene, uint32_t node);

// Returns the accessor of a semantic, if there is such an attribute.
gltf::Index attributeOf(const gltf::Attributes& attributes, const std::string& semantic);

}  // namespace cleave
