#include "tree/walk.h"

#include <gtest/gtest.h>

namespace cleave {
namespace {

// The root is split at x = 1 into leaf 1 and node 2, and that at y = 3 into leaves 3 and 4.
KdTree threeLeaves() {
    KdTree tree;
    tree.bounds = {vec3(0), vec3(4)};
    tree.nodes = {innerNode(0, 1.0f, 1), leafNode(0, 0), innerNode(1, 3.0f, 3), leafNode(0, 0), leafNode(0, 0)};
    return tree;
}

struct Expected {
    uint32_t node, depth;
    vec3 lo, hi;
};

TEST(Walk, GoesDepthFirstAndLeftFirst) {
    const Expected expected[] = {{0, 0, vec3(0), vec3(4)},
                                 {1, 1, vec3(0), vec3(1, 4, 4)},
                                 {2, 1, vec3(1, 0, 0), vec3(4)},
                                 {3, 2, vec3(1, 0, 0), vec3(4, 3, 4)},
                                 {4, 2, vec3(1, 3, 0), vec3(4)}};
    const KdTree tree = threeLeaves();
    std::vector<NodeVisit> visits;
    forEachNode(tree, [&](const NodeVisit& visit) { visits.push_back(visit); });
    ASSERT_EQ(visits.size(), std::size(expected));
    for (size_t i = 0; i < visits.size(); ++i) {
        EXPECT_EQ(visits[i].node, expected[i].node) << i;
        EXPECT_EQ(visits[i].depth, expected[i].depth) << i;
        EXPECT_EQ(visits[i].cell.lo, expected[i].lo) << i;
        EXPECT_EQ(visits[i].cell.hi, expected[i].hi) << i;
    }
}

TEST(Walk, VisitsATreeOfOneLeafOnce) {
    KdTree tree;
    tree.nodes = {leafNode(0, 0)};
    int visits = 0;
    forEachNode(tree, [&](const NodeVisit& visit) { visits += visit.node == 0 && visit.depth == 0 ? 1 : 100; });
    EXPECT_EQ(visits, 1);
}

}  // namespace
}  // namespace cleave
