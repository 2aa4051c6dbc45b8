// Where a picture is taken from, and its rays.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "shared/box.h"
#include "shared/picture.h"

namespace cleave {

// The bounds of the triangles whose vertices are all finite; empty without any.
Box finiteBounds(std::span<const Triangle> triangles);

// Placed at `eye`, looking at `target`, +y up. If these coincide it looks along -z; if it looks straight up or down,
// another up is taken (+z or -z).
Camera lookAt(const glm::dvec3& eye, const glm::dvec3& target, double verticalFov);

// From a corner of the scene, outside of it: eye = centre + 1.1 * diagonal * normalize(0.6, 0.4, 0.7), 45 degrees.
Camera defaultCamera(const Box& bounds);

// The camera of that name or, failing that, of that number; without a name the scene's first, or the default camera.
// Throws UsageError, listing the scene's cameras, if there is no such camera.
Camera chooseCamera(const Scene& scene, const Box& bounds, const std::string& nameOrIndex);

// What a user says about the view beside the camera; each is left as it is where it is not given.
struct ViewOverrides {
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> look;     // a point to look at
    std::optional<double> verticalFov;  // radians; makes the camera a perspective one
};
// With an eye but no point to look at, it looks at the centre of the bounds.
Camera overridden(const Camera& camera, const Box& bounds, const ViewOverrides& overrides);

// The camera with an image plane of so many pixels; imageRay() (shared/picture.h) gives its rays, with t in [0, tMax].
ImageCamera imageCamera(const Camera& camera, uint32_t width, uint32_t height, float tMax);

}  // namespace cleave
