// The nodes of the scene that is shown, in scene order, with their world transforms.
#pragma once

#include <tiny_gltf.h>

#include <glm/glm.hpp>
#include <vector>

namespace cleave {

struct PlacedNode {
    int node = 0;
    glm::dmat4 toWorld{1.0};
};

// The default scene's nodes (or the first scene's; without scenes, all), depth-first, in listed order. The nodes must
// form a forest (gltf_check).
std::vector<PlacedNode> placeNodes(const tinygltf::Model& model);

}  // namespace cleave
