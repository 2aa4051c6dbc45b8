// Rays that meet edges by chance only.
#include <algorithm>
#include <cmath>

#include "stability/aim.h"
#include "stability/plane_points.h"

namespace cleave {

Place placeOf(const TriangleSet& set) {
    if (set.included.empty()) return {dvec3(0.0), dvec3(1.0), std::sqrt(3.0)};
    const double scale = std::ldexp(1.0, set.exponent);
    Place place{dvec3(set.bounds.lo) * scale, dvec3(set.bounds.hi) * scale, 0.0};
    place.diagonal = glm::length(place.hi - place.lo);
    for (int axis = 0; axis < 3; ++axis) {
        const double missing = std::max(0.0, 0.01 * place.diagonal - (place.hi[axis] - place.lo[axis]));
        place.lo[axis] -= 0.5 * missing;
        place.hi[axis] += 0.5 * missing;
    }
    return place;
}

namespace {

const Triangle& anyTriangle(const Target& target, Random& random) {
    return target.world[target.set.included[random.below(target.set.included.size())]];
}

dvec3 inside(const Triangle& t, Random& random) {
    const double u = random.unit(), v = random.unit();
    const double b = u + v > 1.0 ? 1.0 - u : u, c = u + v > 1.0 ? 1.0 - v : v;
    return dvec3(t.a) + b * (dvec3(t.b) - dvec3(t.a)) + c * (dvec3(t.c) - dvec3(t.a));
}

// Half of them at a point of a triangle, or sparse scenes would hardly be hit.
dvec3 anyTarget(const Target& target, const Place& place, Random& random) {
    if (target.set.included.empty() || random.below(2) == 0) return random.inBox(place.lo, place.hi);
    return inside(anyTriangle(target, random), random);
}

std::vector<Ray> randomRays(const Target& target) {
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t) {
        return aimed(around(random, place), anyTarget(target, place, random));
    });
}

// From 10 to 1e4 diagonals away, one in 16 up to 1e6: there a float's error in t is as large as the scene, and a ray
// visits all that may lie in its way.
std::vector<Ray> farRays(const Target& target) {
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t i) {
        const double way = place.diagonal * std::pow(10.0, random.between(1.0, i % 16 == 0 ? 6.0 : 4.0));
        const dvec3 to = anyTarget(target, place, random);
        return aimed(to + way * random.direction(), to);
    });
}

// One or two components of the direction are 0 or -0.
std::vector<Ray> zeroRays(const Target& target) {
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t i) {
        const vec3 to(anyTarget(target, place, random));
        if (i % 2 == 0) return alongAxis(random, place, to);
        Ray ray = aimed(vec3(around(random, place)), to);
        const int axis = static_cast<int>(random.below(3));
        ray.direction[axis] = random.below(2) == 0 ? 0.0f : -0.0f;
        ray.origin[axis] = to[axis];
        return ray;
    });
}

// At 1e-1 to 1e-7 of a triangle's plane.
std::vector<Ray> grazingRays(const Target& target) {
    if (target.set.included.empty()) return {};
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t) {
        const Triangle& t = anyTriangle(target, random);
        // In units of the diagonal, since at extreme scales a cross product leaves the range of double.
        const dvec3 e1 = (dvec3(t.b) - dvec3(t.a)) / place.diagonal, e2 = (dvec3(t.c) - dvec3(t.a)) / place.diagonal;
        const dvec3 along = glm::normalize(random.between(-1.0, 1.0) * e1 + random.between(-1.0, 1.0) * e2);
        const dvec3 normal = glm::normalize(glm::cross(e1, e2));
        const dvec3 d = along + random.sign() * std::pow(10.0, random.between(-7.0, -1.0)) * normal;
        const dvec3 to = inside(t, random);
        return aimed(to - random.unit() * place.diagonal * d, to);
    });
}

// From where other rays hit, to anywhere: as secondary rays without an offset.
std::vector<Ray> surfaceRays(const Target& target) {
    const Place place = placeOf(target.set);
    const std::vector<Ray> first = randomRays(target);
    const std::vector<Hit> hits = target.answer(first);
    std::vector<dvec3> points;
    for (size_t i = 0; i < first.size(); ++i)
        if (hits[i].prim != kNone)
            points.push_back(dvec3(first[i].origin) + double{hits[i].t} * dvec3(first[i].direction));
    if (points.empty()) return {};
    return collect(target, [&](Random& random, uint64_t i) {
        const dvec3& from = points[i % points.size()];
        return aimed(from, from + place.diagonal * random.direction());
    });
}

float sizeOf(const Triangle& t) { return std::max(largestComponent(t.b - t.a), largestComponent(t.c - t.a)); }

// From floats that are exactly in a triangle's plane, and from such as double would place on either side of it. Half as
// many as are wanted: each takes a search. Triangles below 1e-15 of the scene are left out: a hair off their planes, t
// is below the smallest normal number in the scale of a tree, and trees of different scales round it in their own ways.
std::vector<Ray> planeStartRays(const Target& target) {
    if (target.set.included.empty()) return {};
    const Place place = placeOf(target.set);
    Target half = target;
    half.count = (target.count + 1) / 2;
    return collect(half, [&](Random& random, uint64_t i) {
        const Triangle& t = anyTriangle(target, random);
        std::optional<vec3> from;
        if (sizeOf(t) > 1e-15 * place.diagonal)
            from = i % 2 == 0 ? pointInPlane(t, random) : pointBesidePlane(t, random);
        if (!from) return Ray{vec3(0.0f), 0.0f, vec3(0.0f), 0.0f};  // no valid one
        return aimed(*from, vec3(dvec3(*from) + place.diagonal * random.direction()));
    });
}

// Directions from the smallest denormals to the largest floats.
std::vector<Ray> lengthRays(const Target& target) {
    const Place place = placeOf(target.set);
    constexpr double kLengths[] = {1e-44, 1e-40, 1e-38, 1e-30, 1e-10, 1e10, 1e30, 3e38};
    return collect(target, [&](Random& random, uint64_t i) {
        const dvec3 from = around(random, place), way = anyTarget(target, place, random) - from;
        const double largest = std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)});
        return Ray{vec3(from), 0.0f, vec3(way / largest * kLengths[i % std::size(kLengths)]), infinity()};
    });
}

constexpr RayFamily kFamilies[] = {
    {"random", "from around the scene into it", false, false, randomRays},
    {"far", "from 10 to 1e6 diagonals away", false, false, farRays},
    {"zeros", "one or two components 0 or -0", false, false, zeroRays},
    {"grazing", "1e-1 to 1e-7 off a triangle's plane", false, false, grazingRays},
    {"surface", "from points that were hit", false, false, surfaceRays},
    {"plane-starts", "from a triangle's plane, exactly or nearly so", false, false, planeStartRays},
    {"lengths", "directions of length 1e-44 to 3e38", false, false, lengthRays},
};

}  // namespace

std::span<const RayFamily> generalFamilies() { return kFamilies; }

}  // namespace cleave
