#include "scene/camera.h"

#include <cmath>
#include <numbers>

#include "scene/not_found.h"
#include "scene/pose.h"

namespace cleave {
namespace {

using glm::dvec3;

constexpr double kDefaultFov = std::numbers::pi / 4.0;

// The diagonal of a box, or 1 where it has none: a scene without extent has no scale of its own.
double diagonalOf(const Box& bounds) {
    const double diagonal = isEmpty(bounds) ? 0.0 : glm::length(dvec3(bounds.hi) - dvec3(bounds.lo));
    return diagonal > 0.0 ? diagonal : 1.0;
}

dvec3 centreOf(const Box& bounds) { return isEmpty(bounds) ? dvec3(0.0) : 0.5 * (dvec3(bounds.lo) + dvec3(bounds.hi)); }

// Half the height of the picture: at distance 1, or at any distance for an orthographic camera.
double halfHeight(const Camera& camera) {
    return camera.orthographic ? 0.5 * camera.orthographicHeight : std::tan(0.5 * camera.verticalFov);
}

}  // namespace

Box finiteBounds(std::span<const Triangle> triangles) {
    Box bounds = emptyBox();
    for (const Triangle& t : triangles)
        if (isFinite3(t.a) && isFinite3(t.b) && isFinite3(t.c))
            bounds = including(including(including(bounds, t.a), t.b), t.c);
    return bounds;
}

Camera lookAt(const dvec3& eye, const dvec3& target, double verticalFov) {
    Camera camera;
    camera.eye = eye;
    camera.verticalFov = verticalFov;
    const dvec3 way = target - eye;
    const double distance = glm::length(way);
    if (distance > 0.0) camera.forward = way / distance;
    dvec3 up(0.0, 1.0, 0.0);
    if (glm::length(glm::cross(camera.forward, up)) < 1e-9) up = {0.0, 0.0, camera.forward.y > 0.0 ? 1.0 : -1.0};
    const dvec3 right = glm::normalize(glm::cross(camera.forward, up));
    camera.up = glm::cross(right, camera.forward);
    return camera;
}

Camera defaultCamera(const Box& bounds) {
    const dvec3 centre = centreOf(bounds);
    const dvec3 eye = centre + 1.1 * diagonalOf(bounds) * glm::normalize(dvec3(0.6, 0.4, 0.7));
    Camera camera = lookAt(eye, centre, kDefaultFov);
    camera.name = "default";
    return camera;
}

Camera chooseCamera(const PosedScene& scene, const Box& bounds, const std::string& nameOrIndex) {
    if (nameOrIndex.empty()) return scene.cameras.empty() ? defaultCamera(bounds) : scene.cameras.front();
    return scene.cameras[findNamed(scene.cameras, nameOrIndex, "camera", scene.name)];
}

Camera overridden(const Camera& camera, const Box& bounds, const ViewOverrides& overrides) {
    Camera result = camera;
    if (overrides.eye || overrides.look) {
        const dvec3 eye = overrides.eye.value_or(camera.eye);
        const Camera turned = lookAt(eye, overrides.look.value_or(centreOf(bounds)), camera.verticalFov);
        result.eye = turned.eye;
        result.forward = turned.forward;
        result.up = turned.up;
    }
    if (overrides.verticalFov) {
        result.orthographic = false;
        result.verticalFov = *overrides.verticalFov;
    }
    return result;
}

ImageCamera imageCamera(const Camera& camera, uint32_t width, uint32_t height, float tMax) {
    ImageCamera image;
    image.eye = camera.eye;
    image.forward = camera.forward;
    image.right = glm::cross(camera.forward, camera.up);
    image.up = camera.up;
    image.pixel = 2.0 * halfHeight(camera) / height;
    image.width = width;
    image.height = height;
    image.orthographic = camera.orthographic ? 1 : 0;
    image.tMax = tMax;
    return image;
}

}  // namespace cleave
