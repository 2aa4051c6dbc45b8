// A ray's line against a triangle, as the reference sees it: world space, exact signs, t to a known error.
#pragma once

#include "shared/ray.h"
#include "shared/triangle.h"

namespace cleave {

struct LineHit {
    bool hits = false;   // edge-inclusive, two-sided; a line in the triangle's plane misses
    double t = 0.0;      // with a relative error of at most 3e-9
    double slack = 0.0;  // an absolute error that double arithmetic on the same triangle may well make
};

// Decided without rounding, for finite floats of any size.
LineHit intersectLine(const Ray& ray, const Triangle& triangle);

// t of a line that hits, as an unevaluated sum of two doubles: `high` alone has a relative error of at most
// 2^-49, high + low of at most 2^-98. Exact sums, one division, and the exact residual of that division;
// tests hold it against integers of 128 bits.
struct PreciseT {
    double high = 0.0;
    double low = 0.0;
};
PreciseT preciseT(const Ray& ray, const Triangle& triangle);

// Whether the ray's line passes an edge of the triangle within `ulps` units in the last place of that edge's largest
// coordinate (a float). Computed in double, whose error is 2^-50 of the way from the ray's origin.
bool passesNearEdge(const Ray& ray, const Triangle& triangle, double ulps);

}  // namespace cleave
