#include "scene/place_camera.h"

#include <cmath>
#include <numbers>

namespace cleave {
namespace {

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

// glTF 2.0, section 3.10: a camera looks along -z of its node, +y is up, and the node's scale does not count.
std::optional<Camera> placeCamera(const gltf::Camera& camera, const std::string& nodeName, const glm::dmat4& toWorld) {
    Camera placed;
    placed.name = camera.name.empty() ? nodeName : camera.name;
    placed.orthographic = camera.orthographic;
    placed.verticalFov = placed.orthographic ? 0.0 : camera.verticalFov;
    placed.orthographicHeight = placed.orthographic ? 2.0 * camera.yMagnification : 0.0;
    const double size = placed.orthographic ? placed.orthographicHeight : placed.verticalFov;
    if (!(size > 0.0) || !std::isfinite(size)) return std::nullopt;
    if (!placed.orthographic && size >= std::numbers::pi) return std::nullopt;

    placed.eye = glm::dvec3(toWorld[3]);
    placed.forward = glm::normalize(-glm::dvec3(toWorld[2]));
    const glm::dvec3 up = glm::dvec3(toWorld[1]);
    placed.up = glm::normalize(up - placed.forward * glm::dot(up, placed.forward));
    if (!isFinite(placed.eye) || !isFinite(placed.forward) || !isFinite(placed.up)) return std::nullopt;
    return placed;
}

// KHR_lights_punctual: a light shines along -z of its node.
std::optional<PlacedLight> placeLight(const Scene& scene, uint32_t light, const glm::dmat4& toWorld) {
    PlacedLight placed;
    placed.light = light;
    placed.position = glm::dvec3(toWorld[3]);
    const glm::dvec3 direction = glm::normalize(-glm::dvec3(toWorld[2]));
    if (isFinite(direction))
        placed.direction = direction;
    else if (scene.lights[light].type != gltf::LightType::point)
        return std::nullopt;
    if (!isFinite(placed.position)) return std::nullopt;
    return placed;
}

}  // namespace cleave
