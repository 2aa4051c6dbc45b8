#include "instances/mesh_shape.h"

#include <algorithm>
#include <array>

namespace cleave {
namespace {

bool isPlainCoordinate(float x) { return x == 0.0f || std::fabs(x) >= 2.0f * kSmallestNormal; }

bool keepsBits(float x, int exponent) { return x == 0.0f || binaryExponent(x) - exponent >= -126; }

std::vector<vec3> distinct(std::span<const Triangle> triangles) {
    std::vector<vec3> all;
    all.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) all.insert(all.end(), {t.a, t.b, t.c});
    // By bits, so that what is not a number has its place, too.
    const auto bits = [](const vec3& v) {
        return std::array<uint32_t, 3>{floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z)};
    };
    std::sort(all.begin(), all.end(), [&](const vec3& a, const vec3& b) { return bits(a) < bits(b); });
    all.erase(std::unique(all.begin(), all.end(), [&](const vec3& a, const vec3& b) { return bits(a) == bits(b); }),
              all.end());
    return all;
}

vec3 inPlace(const glm::dmat4& m, const vec3& v) {
    const auto row = [&](int i) { return float(transformedBy(m[0][i], m[1][i], m[2][i], m[3][i], glm::dvec3(v))); };
    return {row(0), row(1), row(2)};
}

bool hasTwoVertices(const Triangle& t) { return t.a == t.b || t.b == t.c || t.c == t.a; }

}  // namespace

MeshShape shapeOf(std::span<const Triangle> triangles) {
    MeshShape shape;
    shape.vertices = distinct(triangles);
    uint32_t reach = 0;
    for (const vec3& v : shape.vertices) {
        reach = std::max(reach, reachOf(v));
        shape.isKept = shape.isKept && isFinite3(v);
    }
    shape.exponent = sceneExponent(reach);
    for (const vec3& v : shape.vertices)
        for (int axis = 0; axis < 3; ++axis) shape.isKept = shape.isKept && keepsBits(v[axis], shape.exponent);
    for (uint32_t i = 0; shape.isKept && i < triangles.size(); ++i) {
        if (hasTwoVertices(triangles[i]))
            shape.noArea++;
        else if (liesOnALine(scaledTriangle(triangles[i], -shape.exponent)))
            shape.slivers.push_back(i);
    }
    return shape;
}

Triangle inPlace(const glm::dmat4& toWorld, const Triangle& t) {
    return {inPlace(toWorld, t.a), inPlace(toWorld, t.b), inPlace(toWorld, t.c)};
}

PlacedExtent extentOf(const MeshShape& shape, const glm::dmat4& toWorld) {
    PlacedExtent extent;
    for (const vec3& vertex : shape.vertices) {
        const vec3 v = inPlace(toWorld, vertex);
        extent.box = including(extent.box, v);
        extent.reach = std::max(extent.reach, reachOf(v));
        extent.isPlain = extent.isPlain && isFinite3(v) && isPlainCoordinate(v.x) && isPlainCoordinate(v.y) &&
                         isPlainCoordinate(v.z);
    }
    return extent;
}

}  // namespace cleave
