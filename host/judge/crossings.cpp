#include "judge/crossings.h"

#include <algorithm>
#include <cmath>

#include "judge/reference_triangle.h"
#include "shared/crossing.h"
#include "tree/exact_sum.h"

namespace cleave {
namespace {

// The crossing with one triangle, as kernels find it; a miss outside the ray's interval.
Hit crossingWith(const TriangleSet& set, uint32_t prim, const ScaledRay& ray, int& side) {
    const Triangle& t = set.triangles[prim];
    if (filterTriangle(ray.origin, ray.direction, t.a, t.b, t.c).misses) return missedHit();
    const Crossing c = crossTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
    if (c.side == 0 || c.t < ray.tMin || c.t > ray.tMax) return missedHit();
    side = c.side;
    return {timesPowerOfTwo(c.t, ray.tExponent), prim, c.u, c.v};
}

// A vertex in the sheared plane, times the direction's largest component, without rounding.
struct Sheared {
    ExactSum x, y;
};

Sheared shearedExactly(const Ray& ray, const vec3& v, int k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const auto along = [&](int axis) {
        ExactSum sum;
        const double d = ray.direction[k], e = ray.direction[axis];
        sum.addProduct(v[axis], d);
        sum.addProduct(-ray.origin[axis], d);
        sum.addProduct(-v[k], e);
        sum.addProduct(ray.origin[k], e);
        return sum;
    };
    return {along(i), along(j)};
}

ExactSum differenceOf(const ExactSum& a, const ExactSum& b) {
    ExactSum sum = a;
    sum.addMultiple(b, -1.0);
    return sum;
}

// On which side of the edge from a to b the point (e, e^2) lies, for an endlessly small e.
int sideOfEdge(const Sheared& a, const Sheared& b) {
    ExactSum side = productOf(a.x, b.y);
    side.addMultiple(productOf(a.y, b.x), -1.0);
    if (side.sign() != 0) return side.sign();
    if (const int sign = differenceOf(a.y, b.y).sign(); sign != 0) return sign;
    return differenceOf(b.x, a.x).sign();
}

bool isFiniteTriangle(const Triangle& t) { return isFinite3(t.a) && isFinite3(t.b) && isFinite3(t.c); }

// By (t, number).
void sort(std::vector<Hit>& hits) { std::sort(hits.begin(), hits.end(), isCloser); }

}  // namespace

std::vector<Hit> bruteCrossings(const TriangleSet& set, const Ray& ray) {
    std::vector<Hit> hits;
    if (!isValidRay(ray)) return hits;
    const ScaledRay scaled = scaledRay(ray, set.exponent);
    for (const uint32_t prim : set.included) {
        int side = 0;
        const Hit hit = crossingWith(set, prim, scaled, side);
        if (side != 0) hits.push_back(hit);
    }
    sort(hits);
    return hits;
}

int bruteWinding(const TriangleSet& set, const Ray& ray) {
    int total = 0;
    if (!isValidRay(ray)) return total;
    const ScaledRay scaled = scaledRay(ray, set.exponent);
    for (const uint32_t prim : set.included) {
        int side = 0;
        crossingWith(set, prim, scaled, side);
        total += side;
    }
    return total;
}

int crossesOnce(const Ray& ray, const Triangle& triangle) {
    const vec3& d = ray.direction;
    int k = std::fabs(d.x) >= std::fabs(d.y) ? 0 : 1;
    if (std::fabs(d.z) > std::fabs(d[k])) k = 2;
    const Sheared a = shearedExactly(ray, triangle.a, k), b = shearedExactly(ray, triangle.b, k),
                  c = shearedExactly(ray, triangle.c, k);
    const int side = sideOfEdge(a, b);
    if (side == 0 || sideOfEdge(b, c) != side || sideOfEdge(c, a) != side) return 0;
    return d[k] > 0.0f ? side : -side;
}

std::vector<Hit> referenceCrossings(std::span<const Triangle> world, const Ray& ray) {
    std::vector<Hit> hits;
    if (!isValidRay(ray)) return hits;
    for (uint32_t prim = 0; prim < world.size(); ++prim) {
        if (!isFiniteTriangle(world[prim]) || crossesOnce(ray, world[prim]) == 0) continue;
        const PreciseT exact = preciseT(ray, world[prim]);
        if (exact.high < 0.0) continue;
        const auto t = static_cast<float>(exact.high);
        if (t >= ray.tMin && t <= std::min(ray.tMax, kLargestFloat)) hits.push_back({t, prim, 0.0f, 0.0f});
    }
    sort(hits);
    return hits;
}

}  // namespace cleave
