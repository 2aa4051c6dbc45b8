// Exact SAH in small nodes without sorting: at every face, all boxes on either side are counted. Quadratic, and for few
// boxes faster than a sort (Hunt, Mark and Stoll 2006; survey section 6).
#pragma once

#include "tree/clipped_ref.h"

namespace cleave {

constexpr size_t kMostScanned = 64;  // references of a node that can be scanned

// Bits of axes.
constexpr uint32_t kAllAxes = 7;
constexpr uint32_t onlyAxis(uint32_t axis) { return 1u << axis; }

// The best of the planes through faces of the node's boxes along these axes, planar references tried on either side:
// what a sweep over sorted events finds, bit for bit. No split if no face is strictly inside the cell. The node has at
// most kMostScanned references.
Split bestFace(const NodeToSplit& node, uint32_t axes);

}  // namespace cleave
