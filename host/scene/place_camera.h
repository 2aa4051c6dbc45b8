// Places cameras and lights of the file where their nodes are.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/pose.h"

namespace cleave {

// Returns nothing if the camera shows no picture: an angle outside (0, pi), no height, or a transform that leaves no
// direction.
std::optional<Camera> placeCamera(const gltf::Camera& camera, const std::string& nodeName, const glm::dmat4& toWorld);

// Returns nothing if the light is nowhere, or needs a direction and the transform leaves none.
std::optional<PlacedLight> placeLight(const Scene& scene, uint32_t light, const glm::dmat4& toWorld);

}  // namespace cleave
