// Cameras and lights of the file, placed by a node.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "pose.h"

namespace cleave {

// Nothing if it shows no picture: an angle outside (0, pi), no height, or a transform that leaves no direction.
std::optional<Camera> placeCamera(const gltf::Camera& camera, const std::string& nodeName, const glm::dmat4& toWorld);

// Nothing if it is nowhere, or has to shine some way and the transform leaves no direction.
std::optional<PlacedLight> placeLight(const Scene& scene, uint32_t light, const glm::dmat4& toWorld);

}  // namespace cleave
