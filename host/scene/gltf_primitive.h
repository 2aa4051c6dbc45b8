// A mesh primitive, placed by a node, becomes triangles of the scene.
#pragma once

#include <tiny_gltf.h>

#include <glm/glm.hpp>
#include <string>

#include "scene/scene.h"

namespace cleave {

// Appends the triangles of a primitive in scene order, or counts it in scene.leftOut; `where` names it in messages.
// Throws if the scene would have more than `mostTriangles`.
void addPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const glm::dmat4& toWorld,
                  const std::string& where, size_t mostTriangles, Scene& scene);

}  // namespace cleave
