// Finds out why nodes became leaves, from the finished tree of any builder.
#pragma once

#include <cstdint>

#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// Leaves counted by the first reason that holds; they sum to the tree's leaves.
struct LeafReasons {
    uint64_t empty = 0;           // there is no triangle
    uint64_t depthLimit = 0;      // no deeper leaf is allowed
    uint64_t collapsedAxes = 0;   // the cell has at least two extents below the smallest normal float
    uint64_t identicalBoxes = 0;  // several triangles whose boxes are all the same, and no plane divides these
    uint64_t noPlane = 0;         // no face of a box lies strictly inside the cell
    uint64_t cost = 0;            // no split costs less than the leaf does, by exact SAH
    uint64_t wouldPay = 0;  // one does: a median builder's leaf size, samples or bins that missed it, the memory limit
};

// `settings` are those of the build. Clips every reference once more: about the time of a build. O(n log n) per leaf.
LeafReasons countLeafReasons(const KdTree& tree, const TriangleSet& set, const BuildSettings& settings);

}  // namespace cleave
