// Functions that the families of rays share: the place of the scene, and rays from point to point.
#pragma once

#include <vector>

#include "stability/ray_families.h"

namespace cleave {

// The included triangles' bounds in world space, and their diagonal; a unit box without any. An axis without extent is
// given a little, so that rays pass beside flat scenes, too.
struct Place {
    dvec3 lo, hi;
    double diagonal;
};
Place placeOf(const TriangleSet& set);

// Ray by ray: `make(random, i)` is called until there are target.count rays or 4 times as many calls were made; what is
// no valid ray (an overflow at extreme scales, a direction of no length) is left out.
template <class Make>
std::vector<Ray> collect(const Target& target, Make make) {
    Random random(target.seed);
    std::vector<Ray> rays;
    for (uint64_t i = 0; i < 4 * target.count && rays.size() < target.count; ++i) {
        const Ray ray = make(random, i);
        if (isValidRay(ray)) rays.push_back(ray);
    }
    return rays;
}

// As a user aims: the direction is the rounded difference of two floats.
inline Ray aimed(const vec3& from, const vec3& to) { return {from, 0.0f, to - from, infinity()}; }
inline Ray aimed(const dvec3& from, const dvec3& to) { return aimed(vec3(from), vec3(to)); }

// Somewhere in the scene or up to a diagonal beside it.
inline dvec3 around(Random& random, const Place& place) {
    return random.inBox(place.lo - dvec3(place.diagonal), place.hi + dvec3(place.diagonal));
}

// A ray along an axis through `point`, of which it keeps the two other coordinates to the bit.
inline Ray alongAxis(Random& random, const Place& place, const vec3& point) {
    const int axis = static_cast<int>(random.below(3));
    const bool up = random.below(2) == 0;
    Ray ray{point, 0.0f, vec3(random.below(2) == 0 ? 0.0f : -0.0f), infinity()};
    ray.direction[axis] = up ? 1.0f : -1.0f;
    ray.origin[axis] =
        static_cast<float>(up ? place.lo[axis] - 0.5 * place.diagonal : place.hi[axis] + 0.5 * place.diagonal);
    return ray;
}

}  // namespace cleave
