// The twins of the kernels query_overlaps and query_contains.
#pragma once

#include <vector>

#include "shared/box.h"
#include "shared/triangle.h"
#include "tree/triangle_set.h"

namespace cleave {

// Same arithmetic: the shared functions in the plainest of loops. The triangles that meet a box of the world,
// ascending; none if it is no box.
std::vector<uint32_t> bruteOverlaps(const TriangleSet& set, const Box& box);
// Whether a point is inside of a closed surface or on it.
bool bruteContains(const TriangleSet& set, const vec3& point);

}  // namespace cleave
