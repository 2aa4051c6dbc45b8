#include "scene/gltf_camera.h"

#include <cmath>
#include <numbers>

namespace cleave {

// glTF 2.0, section 3.10: a camera looks along -z of its node, +y is up, and the node's scale does not count.
std::optional<Camera> placeCamera(const tinygltf::Camera& camera, const std::string& nodeName,
                                  const glm::dmat4& toWorld) {
    Camera placed;
    placed.name = camera.name.empty() ? nodeName : camera.name;
    placed.orthographic = camera.type == "orthographic";
    placed.verticalFov = placed.orthographic ? 0.0 : camera.perspective.yfov;
    placed.orthographicHeight = placed.orthographic ? 2.0 * camera.orthographic.ymag : 0.0;
    const double size = placed.orthographic ? placed.orthographicHeight : placed.verticalFov;
    if (!(size > 0.0) || !std::isfinite(size)) return std::nullopt;
    if (!placed.orthographic && size >= std::numbers::pi) return std::nullopt;

    placed.eye = glm::dvec3(toWorld[3]);
    placed.forward = glm::normalize(-glm::dvec3(toWorld[2]));
    const glm::dvec3 up = glm::dvec3(toWorld[1]);
    placed.up = glm::normalize(up - placed.forward * glm::dot(up, placed.forward));
    for (const glm::dvec3& v : {placed.eye, placed.forward, placed.up})
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
    return placed;
}

}  // namespace cleave
