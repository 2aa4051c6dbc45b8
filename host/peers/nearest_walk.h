// Nearest points by the textbook, to compare with: a recursive walk of the kd-tree on one thread of the CPU.
#pragma once

#include <span>

#include "shared/ray.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// The nearest triangle of each point, t being the distance; the nearer child first, the other one where the plane is
// nearer than the best so far. In double, without any bound on rounding.
std::vector<Hit> nearestWalk(const KdTree& tree, const TriangleSet& set, std::span<const vec3> points);

}  // namespace cleave
