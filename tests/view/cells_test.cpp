#include "view/cells.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace cleave {
namespace {

// A root cell from 0 to 1, cut at x = 1/2; its upper half at y = 1/4. In the world it is four times as large.
KdTree handTree() {
    KdTree tree;
    tree.bounds = {{0, 0, 0}, {1, 1, 1}};
    tree.exponent = 2;
    tree.nodes = {innerNode(0, 0.5f, 1), leafNode(0, 3), innerNode(1, 0.25f, 3), leafNode(3, 0), leafNode(3, 2)};
    tree.leafTriangles = {0, 1, 2, 3, 4};
    return tree;
}

Ray rayFrom(const vec3& origin, const vec3& direction) {
    Ray ray{};
    ray.origin = origin;
    ray.direction = direction;
    ray.tMax = 1e30f;
    return ray;
}

TEST(Cells, PlanesAreThoseOfTheNodesAbove) {
    const KdTree tree = handTree();
    EXPECT_EQ(rootCell(tree).hi, glm::dvec3(4.0));
    EXPECT_TRUE(cutPlanes(tree, 0, 100).empty());
    ASSERT_EQ(cutPlanes(tree, 1, 100).size(), 1u);
    const std::vector<CutPlane> planes = cutPlanes(tree, 9, 100);
    ASSERT_EQ(planes.size(), 2u);
    EXPECT_EQ(planes[0].box.lo, glm::dvec3(2, 0, 0));
    EXPECT_EQ(planes[0].box.hi, glm::dvec3(2, 4, 4));
    EXPECT_EQ(planes[1].axis, 1u);
    EXPECT_EQ(planes[1].depth, 1u);
    EXPECT_EQ(planes[1].box.lo, glm::dvec3(2, 1, 0));
    EXPECT_EQ(planes[1].box.hi, glm::dvec3(4, 1, 4));
    EXPECT_EQ(cutPlanes(tree, 9, 1).size(), 1u);
}

TEST(Cells, ARayPassesLeavesInOrder) {
    const KdTree tree = handTree();
    const std::vector<PassedLeaf> leaves = leavesAlong(tree, rayFrom({-1, 3, 2}, {2, 0, 0}));
    ASSERT_EQ(leaves.size(), 2u);
    EXPECT_EQ(leaves[0].triangles, 3u);
    EXPECT_EQ(leaves[0].depth, 1u);
    EXPECT_DOUBLE_EQ(leaves[0].entry, 0.5);
    EXPECT_DOUBLE_EQ(leaves[0].exit, 1.5);
    EXPECT_EQ(leaves[1].triangles, 2u);
    EXPECT_DOUBLE_EQ(leaves[1].entry, 1.5);
    EXPECT_DOUBLE_EQ(leaves[1].exit, 2.5);
    EXPECT_TRUE(leavesAlong(tree, rayFrom({-1, 5, 2}, {1, 0, 0})).empty());
    EXPECT_TRUE(leavesAlong(tree, rayFrom({1, 1, 1}, {0, 0, 0})).empty());
}

// Leaves along a ray are its way through the box, without gaps and one after the other.
TEST(Cells, LeavesAlongARayCoverItsWay) {
    const uint32_t seed = 11;
    std::printf("seed %u\n", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> in(0.0f, 4.0f), way(-1.0f, 1.0f);
    const KdTree tree = handTree();
    for (int i = 0; i < 1000; ++i) {
        const std::vector<PassedLeaf> leaves =
            leavesAlong(tree, rayFrom({in(random), in(random), in(random)}, {way(random), way(random), way(random)}));
        ASSERT_FALSE(leaves.empty());
        EXPECT_EQ(leaves.front().entry, 0.0);
        for (size_t k = 1; k < leaves.size(); ++k) EXPECT_NEAR(leaves[k].entry, leaves[k - 1].exit, 1e-9);
    }
}

}  // namespace
}  // namespace cleave
