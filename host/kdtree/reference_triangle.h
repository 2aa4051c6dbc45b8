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

LineHit intersectLine(const Ray& ray, const Triangle& triangle);

}  // namespace cleave
