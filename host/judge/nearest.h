// The judges of nearest points.
#pragma once

#include "shared/ray.h"
#include "shared/triangle.h"
#include "tree/triangle_set.h"

namespace cleave {

// Same arithmetic: the shared function in the plainest of loops. The nearest triangle at most `within` away, t being
// the distance; ties go to the lower number. The twin of the kernel query_nearest.
Hit bruteNearest(const TriangleSet& set, const vec3& point, float within);

// The reference: the distance of a point and a triangle of the world, of any shape, in arithmetic of 64 bits of
// precision.
double referenceDistance(const Triangle& triangle, const vec3& point);

}  // namespace cleave
