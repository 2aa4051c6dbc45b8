#include "judge/nearest.h"

#include <algorithm>
#include <cmath>

#include "shared/nearest_point.h"

namespace cleave {
namespace {

using Wide = long double;
using Vector = glm::vec<3, Wide>;

Wide segmentDistance(const Vector& p, const Vector& a, const Vector& b) {
    const Vector along = b - a, way = p - a;
    const Wide length = glm::dot(along, along);
    const Wide share = length > 0 ? std::clamp(glm::dot(way, along) / length, Wide(0), Wide(1)) : Wide(0);
    return glm::length(way - share * along);
}

// The plane's distance where the point is above the triangle, between three planes through its edges.
Wide planeDistance(const Vector& p, const Vector& a, const Vector& b, const Vector& c, Wide otherwise) {
    const Vector n = glm::cross(b - a, c - a);
    const Wide size = glm::length(n);
    if (size == 0) return otherwise;
    const auto isWithin = [&](const Vector& from, const Vector& to) {
        return glm::dot(glm::cross(n, to - from), p - from) >= 0;
    };
    if (!isWithin(a, b) || !isWithin(b, c) || !isWithin(c, a)) return otherwise;
    return std::fabs(glm::dot(n, p - a)) / size;
}

}  // namespace

Hit bruteNearest(const TriangleSet& set, const vec3& point, float within) {
    Hit best = missedHit();
    if (!isFinite3(point)) return best;
    best.t = within;
    const dvec3 scaled = scaledPoint(point, set.exponent);
    for (const uint32_t prim : set.included) {
        const NearPoint near = nearestPoint(scaled, set.triangles[prim]);
        const Hit hit{worldDistance(near, set.exponent), prim, static_cast<float>(near.u), static_cast<float>(near.v)};
        if (isFinite(hit.t) && isCloser(hit, best)) best = hit;
    }
    return best.prim == kNone ? missedHit() : best;
}

double referenceDistance(const Triangle& triangle, const vec3& point) {
    const Vector p(point), a(triangle.a), b(triangle.b), c(triangle.c);
    const Wide edges = std::min({segmentDistance(p, a, b), segmentDistance(p, b, c), segmentDistance(p, c, a)});
    return static_cast<double>(std::min(edges, planeDistance(p, a, b, c, edges)));
}

}  // namespace cleave
