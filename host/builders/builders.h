// The builders that run on the CPU. A caller that wants the cost of a build passes a report to be overwritten.
#pragma once

#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// Costs of a build other than time.
struct BuildReport {
    uint64_t peakBytes = 0;    // most bytes held at once, including the tree and its spare capacity
    uint64_t eventsSwept = 0;  // of exact builders: summed over the nodes
    uint64_t sortSteps = 0;    // and n log2 n of each sort of n events, the logarithm rounded up
};

// Exact SAH with perfect splits: every face of every clipped box is a candidate, planar triangles are tried on either
// side (Wald and Havran 2006, survey section 5). Events are sorted once, then spliced and merged: O(N log N). The tree
// is the same for any number of threads, bit for bit.
KdTree buildExact(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);

// The same tree, with events sorted in each node: O(N log^2 N), one thread. Both take settings.smallNodes alike.
KdTree buildExactNLog2N(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);

// Every split halves the cell. Median builders know no costs: they stop at settings.leafSize references, at the depth
// limit, and where splitting only copies references (survey section 4).
KdTree buildSpatialMedian(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);

// Every split goes through the centre of the median box (Bentley 1975; survey sections 2 and 4).
KdTree buildObjectMedian(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);

// The SAH from a few adaptive samples per node instead of from every face; exact in small nodes (Hunt, Mark and Stoll
// 2006; survey section 6). They differ in the axes that are sampled: all, the cell's longest, or all in nodes of at
// most 1024 references and the longest in larger ones. Beyond the paper, unless settings.snap is off, planes move to
// faces, and unless settings.otherAxes is off, nodes that the longest axis cannot split are tried along the others.
KdTree buildHuntAll(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);
KdTree buildHuntHybrid(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);
KdTree buildHuntOne(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);

// The SAH from counters of bins, filled from a part of the references; exact in small nodes; settings.threads threads
// with a subtree each, for which large scenes are cut at medians first (Shevtsov, Soupikov and Kapustin 2007; survey
// section 7). Beyond the paper, unless settings.snap is off, planes move to faces. The same tree in every run with as
// many threads; other numbers of threads cut elsewhere.
KdTree buildShevtsov(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr);

// No tree: one leaf that lists all triangles.
KdTree buildBrute(const TriangleSet& set, const BuildSettings& settings = {}, BuildReport* report = nullptr);

}  // namespace cleave
