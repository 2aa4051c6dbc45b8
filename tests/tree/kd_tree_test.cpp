#include "tree/kd_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "measure/statistics.h"

namespace cleave {
namespace {

// A box of 4 x 2 x 2, cut at x = 1 into a leaf {0} and a node that is cut at y = 1 into {1, 2} and {}.
KdTree smallTree() {
    KdTree tree;
    tree.bounds = {{0, 0, 0}, {4, 2, 2}};
    tree.nodes = {innerNode(0, 1.0f, 1), leafNode(0, 1), innerNode(1, 1.0f, 3), leafNode(1, 2), leafNode(3, 0)};
    tree.leafTriangles = {0, 1, 2};
    return tree;
}

TEST(DepthLimit, FollowsTheFormula) {
    const BuildSettings settings;
    EXPECT_EQ(depthLimit(settings, 0), 8u);
    EXPECT_EQ(depthLimit(settings, 1), 8u);
    EXPECT_EQ(depthLimit(settings, 1024), 21u);   // 8 + 13
    EXPECT_EQ(depthLimit(settings, 69451), 29u);  // 8 + 1.3 * 16.08 = 28.9
    EXPECT_EQ(depthLimit(settings, kMaxLink), 47u) << "the most triangles that a tree can hold";
    BuildSettings given;
    given.maxDepth = 5;
    EXPECT_EQ(depthLimit(given, 1000000), 5u);
    given.maxDepth = 1000;
    EXPECT_EQ(depthLimit(given, 1000000), kMaxDepth);
}

TEST(TreeHash, IgnoresTheOrderInMemory) {
    KdTree moved = smallTree();
    moved.nodes = {innerNode(0, 1.0f, 3), leafNode(2, 2), leafNode(9, 0), leafNode(1, 1), innerNode(1, 1.0f, 1)};
    moved.leafTriangles = {7, 0, 2, 1, 7, 7, 7, 7, 7};
    EXPECT_EQ(treeHash(moved), treeHash(smallTree()));
    EXPECT_EQ(treeHash(moved).size(), 16u);
}

TEST(TreeHash, SeesEveryChange) {
    const std::string hash = treeHash(smallTree());
    KdTree tree = smallTree();
    tree.nodes[0] = innerNode(0, std::nextafter(1.0f, 2.0f), 1);
    EXPECT_NE(treeHash(tree), hash);
    tree = smallTree();
    tree.nodes[2] = innerNode(2, 1.0f, 3);
    EXPECT_NE(treeHash(tree), hash);
    tree = smallTree();
    tree.leafTriangles[0] = 3;
    EXPECT_NE(treeHash(tree), hash);
    tree = smallTree();
    std::swap(tree.nodes[3], tree.nodes[4]);
    EXPECT_NE(treeHash(tree), hash);
    tree = smallTree();
    tree.nodes[3] = leafNode(1, 1);
    EXPECT_NE(treeHash(tree), hash);
}

TEST(TreeHash, RefusesBrokenTrees) {
    EXPECT_THROW(treeHash(KdTree{}), Error);
    KdTree tree = smallTree();
    tree.nodes[2] = innerNode(1, 1.0f, 0);  // a cycle
    EXPECT_THROW(treeHash(tree), Error);
    tree.nodes[2] = innerNode(1, 1.0f, 4);  // beyond the end
    EXPECT_THROW(treeHash(tree), Error);
    tree = smallTree();
    tree.nodes[3] = leafNode(2, 2);
    EXPECT_THROW(treeHash(tree), Error);
}

// Half areas: root 20 (4x2 + 2x2 + 2x4), left leaf 8, right node 16, its leaves 3 + 2 + 6 = 11 each.
TEST(Statistics, WorkedByHand) {
    const TreeStatistics s = computeStatistics(smallTree());
    EXPECT_EQ(s.nodes, 5u);
    EXPECT_EQ(s.leaves, 3u);
    EXPECT_EQ(s.emptyLeaves, 1u);
    EXPECT_EQ(s.references, 3u);
    EXPECT_EQ(s.maxDepth, 2u);
    EXPECT_EQ(s.largestLeaf, 2u);
    EXPECT_EQ(s.leafHistogram[0], 1u);
    EXPECT_EQ(s.leafHistogram[1], 1u);
    EXPECT_EQ(s.leafHistogram[2], 1u);
    EXPECT_DOUBLE_EQ(s.expectedInner.value(), 36.0 / 20.0);
    EXPECT_DOUBLE_EQ(s.expectedLeaves.value(), 30.0 / 20.0);
    EXPECT_DOUBLE_EQ(s.expectedTriangles.value(), (8.0 + 2.0 * 11.0) / 20.0);
    EXPECT_DOUBLE_EQ(s.sahCost.value(), 15.0 * 1.8 + 20.0 * 1.5);
}

TEST(Statistics, CostNamesItsConstants) {
    const TreeStatistics s = computeStatistics(smallTree(), {2.0f, 3.0f, 5.0f, 0.5f});
    EXPECT_DOUBLE_EQ(s.sahCost.value(), 2.0 * 1.8 + 5.0 * 1.5 + 3.0 * 1.5);
    EXPECT_EQ(s.costs.leaf, 5.0f);
}

TEST(Statistics, CostIsNullWithoutArea) {
    KdTree tree = smallTree();
    tree.bounds = {{0, 0, 0}, {4, 0, 0}};
    tree.nodes = {leafNode(0, 3)};
    EXPECT_FALSE(computeStatistics(tree).sahCost.has_value());
    tree.bounds = emptyBox();
    tree.nodes = {leafNode(0, 0)};
    const TreeStatistics s = computeStatistics(tree);
    EXPECT_FALSE(s.expectedLeaves.has_value());
    EXPECT_EQ(s.emptyLeaves, 1u);
}

TEST(Statistics, LargeLeavesShareTheLastEntry) {
    KdTree tree;
    tree.bounds = {{0, 0, 0}, {1, 1, 1}};
    tree.nodes = {leafNode(0, 100)};
    tree.leafTriangles.resize(100);
    const TreeStatistics s = computeStatistics(tree);
    EXPECT_EQ(s.leafHistogram.back(), 1u);
    EXPECT_EQ(s.largestLeaf, 100u);
}

}  // namespace
}  // namespace cleave
