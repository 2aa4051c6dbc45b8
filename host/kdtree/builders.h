// The builders that run on the CPU.
#pragma once

#include "kd_tree.h"
#include "triangle_set.h"

namespace cleave {

// Exact SAH with perfect splits: every face of every clipped box is a candidate, planar triangles are tried on either
// side (Wald and Havran 2006, survey section 5). Events are sorted per node: O(N log^2 N).
KdTree buildExact(const TriangleSet& set, const BuildSettings& settings);

// Every split halves the cell. Median builders know no costs: they stop at settings.leafSize references, at the depth
// limit, and where splitting only copies references (survey section 4).
KdTree buildSpatialMedian(const TriangleSet& set, const BuildSettings& settings);

// Every split goes through the centre of the median box (Bentley 1975; survey sections 2 and 4).
KdTree buildObjectMedian(const TriangleSet& set, const BuildSettings& settings);

// The SAH from a few adaptive samples per node instead of from every face; exact in small nodes (Hunt, Mark and Stoll
// 2006; survey section 6). They differ in the axes that are sampled: all, the cell's longest, or all in nodes of at
// most 1024 references and the longest in larger ones.
KdTree buildHuntAll(const TriangleSet& set, const BuildSettings& settings);
KdTree buildHuntHybrid(const TriangleSet& set, const BuildSettings& settings);
KdTree buildHuntOne(const TriangleSet& set, const BuildSettings& settings);

// No tree: one leaf that lists all triangles.
KdTree buildBrute(const TriangleSet& set);

}  // namespace cleave
