// Cameras in the world, and their rays.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/box.h"
#include "shared/picture.h"
#include "shared/triangle.h"

namespace cleave {

struct PosedScene;

// A camera, placed in the world.
struct Camera {
    std::string name;
    glm::dvec3 eye{0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};  // unit length
    glm::dvec3 up{0.0, 1.0, 0.0};        // unit length, at a right angle to forward
    bool orthographic = false;
    double verticalFov = 0.0;         // radians; perspective only
    double orthographicHeight = 0.0;  // full height seen; orthographic only
};

// Returns the bounds of the triangles whose vertices are all finite; empty if there are none.
Box finiteBounds(std::span<const Triangle> triangles);

// Places a camera at `eye` that looks at `target`, +y up. If these coincide it looks along -z; if it looks straight up
// or down, another up is taken (+z or -z).
Camera lookAt(const glm::dvec3& eye, const glm::dvec3& target, double verticalFov);

// Looks at the centre of a scene from a corner outside of it: eye = centre + 1.1 * diagonal * normalize(0.6, 0.4, 0.7),
// 45 degrees.
Camera defaultCamera(const Box& bounds);

// Returns the camera of that name or, failing that, of that number; of an empty text the first, or the default camera.
// Throws NotFound, listing the scene's cameras, if there is no such camera.
Camera chooseCamera(const PosedScene& scene, const Box& bounds, const std::string& nameOrIndex);

// Changes that a user makes to a camera; what is not given stays as it is.
struct ViewOverrides {
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> look;     // a point to look at
    std::optional<double> verticalFov;  // radians; makes the camera a perspective one
};
// Applies the changes. With an eye but no point to look at, the camera looks at the centre of the bounds.
Camera overridden(const Camera& camera, const Box& bounds, const ViewOverrides& overrides);

// Gives the camera an image plane of so many pixels. Its rays are those of imageRay() (shared/picture.h), t in [0,
// tMax].
ImageCamera imageCamera(const Camera& camera, uint32_t width, uint32_t height, float tMax);

}  // namespace cleave
