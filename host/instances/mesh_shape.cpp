#include "instances/mesh_shape.h"

#include <algorithm>
#include <array>

namespace cleave {
namespace {

bool isPlainCoordinate(float x) { return x == 0.0f || std::fabs(x) >= 2.0f * kSmallestNormal; }

bool keepsBits(float x, int exponent) { return x == 0.0f || binaryExponent(x) - exponent >= -126; }

// Each once, by bits, so that what is not a number has its place, too.
void makeDistinct(std::vector<vec3>& all) {
    const auto bits = [](const vec3& v) {
        return std::array<uint32_t, 3>{floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z)};
    };
    std::sort(all.begin(), all.end(), [&](const vec3& a, const vec3& b) { return bits(a) < bits(b); });
    all.erase(std::unique(all.begin(), all.end(), [&](const vec3& a, const vec3& b) { return bits(a) == bits(b); }),
              all.end());
}

vec3 inPlace(const glm::dmat4& m, const vec3& v) {
    const auto row = [&](int i) { return float(transformedBy(m[0][i], m[1][i], m[2][i], m[3][i], glm::dvec3(v))); };
    return {row(0), row(1), row(2)};
}

bool hasTwoVertices(const Triangle& t) { return t.a == t.b || t.b == t.c || t.c == t.a; }

}  // namespace

MeshShape shapeOf(std::span<const Triangle> triangles) {
    MeshShape shape;
    uint32_t reach = 0;
    const auto forVertices = [&](const auto& see) {
        for (const Triangle& t : triangles)
            for (const vec3& v : {t.a, t.b, t.c}) see(v);
    };
    forVertices([&](const vec3& v) {
        reach = std::max(reach, reachOf(v));
        shape.isKept = shape.isKept && isFinite3(v);
    });
    shape.exponent = sceneExponent(reach);
    forVertices([&](const vec3& v) {
        for (int axis = 0; axis < 3; ++axis) shape.isKept = shape.isKept && keepsBits(v[axis], shape.exponent);
    });
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const bool hasTwo = hasTwoVertices(t);
        const bool hasArea = !hasTwo && !(shape.isKept && liesOnALine(scaledTriangle(t, -shape.exponent)));
        if (hasTwo) shape.noArea++;
        if (!hasTwo && !hasArea) shape.slivers.push_back(i);
        std::vector<vec3>& vertices = hasArea ? shape.vertices : shape.others;
        vertices.insert(vertices.end(), {t.a, t.b, t.c});
    }
    makeDistinct(shape.vertices);
    makeDistinct(shape.others);
    return shape;
}

Triangle inPlace(const glm::dmat4& toWorld, const Triangle& t) {
    return {inPlace(toWorld, t.a), inPlace(toWorld, t.b), inPlace(toWorld, t.c)};
}

PlacedExtent extentOf(const MeshShape& shape, const glm::dmat4& toWorld) {
    PlacedExtent extent;
    const auto see = [&](const vec3& vertex) {
        const vec3 v = inPlace(toWorld, vertex);
        extent.all = including(extent.all, v);
        extent.reach = std::max(extent.reach, reachOf(v));
        extent.isPlain = extent.isPlain && isFinite3(v) && isPlainCoordinate(v.x) && isPlainCoordinate(v.y) &&
                         isPlainCoordinate(v.z);
    };
    for (const vec3& vertex : shape.vertices) see(vertex);
    extent.box = extent.all;
    for (const vec3& vertex : shape.others) see(vertex);
    return extent;
}

}  // namespace cleave
