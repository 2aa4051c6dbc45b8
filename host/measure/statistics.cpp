#include "measure/statistics.h"

#include <algorithm>

#include "tree/walk.h"

namespace cleave {
namespace {

constexpr size_t kHistogramSize = 33;  // 0 to 31 triangles, and 32 or more

// In double, unlike what builders compute with: a published figure does not depend on their rounding.
double halfAreaOf(const Box& cell) {
    const dvec3 e = dvec3(cell.hi) - dvec3(cell.lo);
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

// Sums of half areas: over inner nodes, over leaves, and over leaves times their triangles.
struct AreaSums {
    double inner = 0.0;
    double leaves = 0.0;
    double triangles = 0.0;
};

void countLeaf(TreeStatistics& s, uint32_t count, uint32_t depth) {
    ++s.leaves;
    s.references += count;
    s.emptyLeaves += count == 0 ? 1 : 0;
    s.maxDepth = std::max(s.maxDepth, depth);
    s.largestLeaf = std::max(s.largestLeaf, count);
    ++s.leafHistogram[std::min<size_t>(count, kHistogramSize - 1)];
    if (s.depthHistogram.size() <= depth) s.depthHistogram.resize(depth + 1);
    ++s.depthHistogram[depth];
}

AreaSums sumAreas(const KdTree& tree, TreeStatistics& s) {
    AreaSums sums;
    forEachNode(tree, [&](const NodeVisit& visit) {
        const KdNode node = tree.nodes[visit.node];
        const double area = isEmpty(tree.bounds) ? 0.0 : halfAreaOf(visit.cell);
        if (!isLeaf(node)) {
            sums.inner += area;
            return;
        }
        countLeaf(s, leafCount(node), visit.depth);
        sums.leaves += area;
        sums.triangles += area * leafCount(node);
    });
    return sums;
}

}  // namespace

TreeStatistics computeStatistics(const KdTree& tree, SahCosts costs) {
    TreeStatistics s;
    s.costs = costs;
    s.nodes = tree.nodes.size();
    s.leafHistogram.assign(kHistogramSize, 0);
    const AreaSums sums = sumAreas(tree, s);
    const double rootArea = isEmpty(tree.bounds) ? 0.0 : halfAreaOf(tree.bounds);
    if (rootArea > 0.0) {
        s.expectedInner = sums.inner / rootArea;
        s.expectedLeaves = sums.leaves / rootArea;
        s.expectedTriangles = sums.triangles / rootArea;
        s.sahCost = double{costs.traverse} * *s.expectedInner + double{costs.leaf} * *s.expectedLeaves +
                    double{costs.intersect} * *s.expectedTriangles;
    }
    return s;
}

}  // namespace cleave
