// The builders that run on the CPU.
#pragma once

#include "kd_tree.h"
#include "triangle_set.h"

namespace cleave {

// Exact SAH with perfect splits: every face of every clipped box is a candidate, planar triangles are tried on either
// side (Wald and Havran 2006, survey section 5). Events are sorted per node: O(N log^2 N).
KdTree buildExact(const TriangleSet& set, const BuildSettings& settings);

// No tree: one leaf that lists all triangles.
KdTree buildBrute(const TriangleSet& set);

}  // namespace cleave
