// Statistics of a tree: counts, depth and expected costs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tree/kd_tree.h"

namespace cleave {

struct TreeStatistics {
    uint64_t nodes = 0;
    uint64_t leaves = 0;
    uint64_t emptyLeaves = 0;
    uint64_t references = 0;  // entries of all leaf lists
    uint32_t maxDepth = 0;    // of a leaf; the root has depth 0
    uint32_t largestLeaf = 0;
    std::vector<uint64_t> leafHistogram;   // [n]: leaves with n triangles, the last entry: that many or more
    std::vector<uint64_t> depthHistogram;  // [d]: leaves at depth d, 0 to maxDepth
    // Survey section 4, for a uniformly distributed line that meets the root box; null if that box has no area.
    SahCosts costs = kDefaultCosts;
    std::optional<double> sahCost;  // costs.traverse inner + costs.leaf leaves + costs.intersect triangles
    std::optional<double> expectedInner;
    std::optional<double> expectedLeaves;
    std::optional<double> expectedTriangles;
};

TreeStatistics computeStatistics(const KdTree& tree, SahCosts costs = kDefaultCosts);

}  // namespace cleave
