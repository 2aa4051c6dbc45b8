// Rays at vertices, edges and grid points, and rays that end at their hit.
#include <array>
#include <cmath>

#include "stability/aim.h"

namespace cleave {
namespace {

std::array<vec3, 3> cornersOf(const Triangle& t) { return {t.a, t.b, t.c}; }

vec3 anyVertex(const Target& target, Random& random) {
    return cornersOf(target.world[target.set.included[random.below(target.set.included.size())]])[random.below(3)];
}

// The middle, or any point, of an edge, rounded to float.
vec3 onAnEdge(const Target& target, Random& random) {
    const auto corners = cornersOf(target.world[target.set.included[random.below(target.set.included.size())]]);
    const uint32_t i = random.below(3);
    const dvec3 p(corners[i]), q(corners[(i + 1) % 3]);
    const double part = random.below(2) == 0 ? 0.5 : random.unit();
    return vec3(p + part * (q - p));
}

using Point = vec3 (*)(const Target&, Random&);

std::vector<Ray> raysAt(const Target& target, Point point) {
    if (target.set.included.empty()) return {};
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t) {
        const vec3 from(around(random, place));
        return aimed(from, point(target, random));
    });
}
std::vector<Ray> axisRaysThrough(const Target& target, Point point) {
    if (target.set.included.empty()) return {};
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t) { return alongAxis(random, place, point(target, random)); });
}

std::vector<Ray> vertexRays(const Target& target) { return raysAt(target, anyVertex); }
std::vector<Ray> edgeRays(const Target& target) { return raysAt(target, onAnEdge); }
std::vector<Ray> axisVertexRays(const Target& target) { return axisRaysThrough(target, anyVertex); }
std::vector<Ray> axisEdgeRays(const Target& target) { return axisRaysThrough(target, onAnEdge); }

// From vertex to vertex: hits at t = 0 and t = 1, and often along edges and inside faces.
std::vector<Ray> fromVertexRays(const Target& target) {
    if (target.set.included.empty()) return {};
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t i) {
        const vec3 from = anyVertex(target, random);
        if (i % 4 == 0) {  // straight from it along an axis
            Ray ray = alongAxis(random, place, from);
            ray.origin = from;
            return ray;
        }
        return aimed(from, i % 4 == 1 ? anyVertex(target, random) : vec3(around(random, place)));
    });
}

// A grid of whole multiples of a power of two, an eighth of the scene or less: on integer scenes all of its points are
// vertices. Along axes and diagonals, and from point to point.
std::vector<Ray> gridRays(const Target& target) {
    const Place place = placeOf(target.set);
    const double step = std::ldexp(1.0, static_cast<int>(std::floor(std::log2(place.diagonal))) - 3);
    const auto snapped = [&](const dvec3& p) { return vec3(glm::round(p / step) * step); };
    return collect(target, [&](Random& random, uint64_t i) {
        const vec3 to = snapped(random.inBox(place.lo, place.hi));
        if (i % 2 == 0) return alongAxis(random, place, to);
        if (i % 4 == 1) return aimed(snapped(around(random, place)), to);
        const dvec3 diagonal(random.sign(), random.sign(), i % 8 == 3 ? 0.0 : random.sign());
        return Ray{vec3(dvec3(to) - 16.0 * step * diagonal), 0.0f, vec3(diagonal), infinity()};
    });
}

// The interval begins or ends at the hit, one float below it, or one float above it.
std::vector<Ray> endingRays(const Target& target) {
    if (target.set.included.empty()) return {};
    Target half = target;
    half.count = target.count / 2;
    std::vector<Ray> rays = raysAt(half, anyVertex);
    const std::vector<Ray> more = raysAt(half, onAnEdge);
    rays.insert(rays.end(), more.begin(), more.end());
    const std::vector<Hit> hits = target.answer(rays);
    std::vector<Ray> ending;
    for (size_t i = 0; i < rays.size(); ++i) {
        const float t = hits[i].t;
        if (hits[i].prim == kNone || t == 0.0f) continue;
        Ray ray = rays[i];
        if (i % 3 != 0) ray.tMax = i / 3 % 3 == 0 ? t : nextFloat(t, i / 3 % 3 == 1);
        if (i % 3 != 1) ray.tMin = i / 3 % 3 == 0 ? t : nextFloat(t, i / 3 % 3 == 2);
        if (isValidRay(ray)) ending.push_back(ray);
    }
    return ending;
}

constexpr RayFamily kFamilies[] = {
    {"vertices", "at vertices", true, false, vertexRays},
    {"edges", "at points of edges", true, false, edgeRays},
    {"axis-vertices", "along an axis through a vertex", true, false, axisVertexRays},
    {"axis-edges", "along an axis through an edge", true, false, axisEdgeRays},
    {"from-vertices", "from a vertex to another, along an axis, or away", true, false, fromVertexRays},
    {"grid", "along axes and diagonals through whole coordinates", true, false, gridRays},
    {"ends", "tMin and tMax at the hit, and a float beside it", true, false, endingRays},
};

}  // namespace

std::span<const RayFamily> edgeFamilies() { return kFamilies; }

}  // namespace cleave
