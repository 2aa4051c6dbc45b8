// Walks the nodes of a scene, and multiplies their transforms.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace cleave {

// Returns the nodes of the default scene (or of the first; without scenes, all), depth-first, in listed order.
std::vector<uint32_t> shownNodes(const Scene& scene);

// Returns a node's own transform, in double.
glm::dmat4 matrixOf(const gltf::Transform& transform);

// Returns the transform of every node to the world, shown or not. `local` has the own matrix of each.
std::vector<glm::dmat4> worldTransforms(const Scene& scene, const std::vector<glm::dmat4>& local);

}  // namespace cleave
