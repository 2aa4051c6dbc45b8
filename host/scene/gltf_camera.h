// A glTF camera, placed by a node.
#pragma once

#include <tiny_gltf.h>

#include <glm/glm.hpp>
#include <optional>

#include "scene/scene.h"

namespace cleave {

// Nothing if it shows no picture: an angle outside (0, pi), no height, or a transform that leaves no direction.
std::optional<Camera> placeCamera(const tinygltf::Camera& camera, const std::string& nodeName,
                                  const glm::dmat4& toWorld);

}  // namespace cleave
