// Small worlds whose light is known, and the mean of what their pictures show of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "builders/builders.h"
#include "run/renderer.h"
#include "support/device.h"
#include "support/runners.h"

namespace cleave::test {

// A square in the plane y = 0, of side 2.
inline std::vector<Triangle> floorSquare() {
    return {{{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}}, {{1, 0, 1}, {-1, 0, 1}, {1, 0, -1}}};
}

inline Material surface(float albedo, float metallic, float roughness, float emission = 0.0f) {
    return plainMaterial({albedo, albedo, albedo, 1.0f}, vec3(emission), metallic, roughness, 0);
}

inline ImageCamera cameraAt(glm::dvec3 eye, glm::dvec3 look, glm::dvec3 up, double tangent, uint32_t size) {
    ImageCamera c{};
    c.eye = eye;
    c.forward = glm::normalize(look - eye);
    c.right = glm::normalize(glm::cross(c.forward, up));
    c.up = glm::cross(c.right, c.forward);
    c.pixel = 2.0 * tangent / size;
    c.width = c.height = size;
    c.tMax = infinity();
    return c;
}

// A world of one material, with a second one for the triangles from `second` on.
inline std::vector<vec3> radiance(const std::vector<Triangle>& world, const std::vector<Material>& made, size_t second,
                                  const PictureRequest& request) {
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(device(), world);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    SurfaceData data;
    data.surfaceOf.assign(world.size(), 0);
    std::fill(data.surfaceOf.begin() + static_cast<ptrdiff_t>(std::min(second, world.size())), data.surfaceOf.end(), 1);
    data.materials = made;
    for (const Material& material : made) data.hasAlpha = data.hasAlpha || !isOpaque(material);
    const DeviceSurfaces surfaces(device(), data);
    Renderer& renderer = sharedRenderer();
    const Picture picture = renderer.render(*tree, triangles, surfaces, request);
    EXPECT_EQ(picture.cappedRays, 0u);
    EXPECT_EQ(picture.samples, request.samples);
    return renderer.readRadiance();
}

inline std::vector<vec3> radiance(const std::vector<Triangle>& world, const Material& material,
                                  const PictureRequest& request) {
    return radiance(world, {material}, world.size(), request);
}

struct Mean {
    double value = 0.0, error = 0.0;  // error: of the mean, one standard deviation
};
inline Mean meanOf(const std::vector<vec3>& pixels) {
    double sum = 0.0, squares = 0.0;
    for (const vec3& p : pixels) {
        sum += double{p.x};
        squares += double{p.x} * double{p.x};
    }
    const auto n = static_cast<double>(pixels.size());
    return {sum / n, std::sqrt(std::max(squares / n - sum / n * (sum / n), 0.0) / n)};
}

}  // namespace cleave::test
