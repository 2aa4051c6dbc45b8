#include <gtest/gtest.h>

#include "builders/builders.h"
#include "judge/validate.h"
#include "measure/statistics.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

// A triangle whose box is the unit cube, moved.
Triangle unitAt(vec3 p) { return {p, p + vec3(1, 1, 0), p + vec3(0.5f, 0.5f, 1)}; }

std::vector<uint32_t> listOf(const KdTree& tree, uint32_t node) {
    const auto begin = tree.leafTriangles.begin() + leafFirst(tree.nodes[node]);
    return {begin, begin + leafCount(tree.nodes[node])};
}

BuildSettings stopAt(uint32_t leafSize, AxisChoice axes = AxisChoice::cycle) {
    BuildSettings settings;
    settings.leafSize = leafSize;
    settings.axes = axes;
    return settings;
}

// Cubes at x = 0, 1 and 6, in units of 1/8 once scaled: the cell's middle is 3.5, the median centre 1.5.
TEST(BuildMedian, ThreeTrianglesWorkedByHand) {
    const TriangleSet set =
        makeTriangleSet(std::vector<Triangle>{unitAt({0, 0, 0}), unitAt({1, 0, 0}), unitAt({6, 0, 0})});
    ASSERT_EQ(set.exponent, 3);
    const KdTree spatial = buildSpatialMedian(set, stopAt(2));
    ASSERT_EQ(spatial.nodes.size(), 3u);
    EXPECT_EQ(nodeAxis(spatial.nodes[0]), 0u);
    EXPECT_EQ(nodePosition(spatial.nodes[0]), 3.5f / 8.0f);
    EXPECT_EQ(listOf(spatial, 1), (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(listOf(spatial, 2), std::vector<uint32_t>{2});
    const KdTree object = buildObjectMedian(set, stopAt(2));
    ASSERT_EQ(object.nodes.size(), 3u);
    EXPECT_EQ(nodePosition(object.nodes[0]), 1.5f / 8.0f);
    EXPECT_EQ(listOf(object, 1), (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(listOf(object, 2), (std::vector<uint32_t>{1, 2}));
}

// 63 cubes in a row, listed out of order (20 and 63 have no common factor): the 32nd holds the plane.
TEST(BuildMedian, MedianIsTheMiddleOne) {
    std::vector<Triangle> row;
    for (uint32_t i = 0; i < 63; ++i) row.push_back(unitAt({static_cast<float>(i * 20 % 63), 0, 0}));
    row[0] = unitAt({1, 0, 0});  // the row is no longer symmetric, its median is
    const TriangleSet set = makeTriangleSet(row);
    ASSERT_EQ(set.exponent, 6);
    EXPECT_EQ(nodePosition(buildObjectMedian(set, stopAt(1)).nodes[0]), 31.5f / 64.0f);
    EXPECT_EQ(nodePosition(buildSpatialMedian(set, stopAt(1)).nodes[0]), 32.0f / 64.0f);
}

// An extent below the smallest normal number is none, even if planes lie inside: a device may take it for zero.
TEST(BuildMedian, LeavesAxesOfDenormalExtentAlone) {
    std::vector<Triangle> sheet;
    for (Triangle t : test::soup(8, 300, 0.05f)) {
        t.a.z = 4e-38f, t.b.z = 4.4e-38f, t.c.z = 4.8e-38f;
        sheet.push_back(t);
    }
    const TriangleSet set = makeTriangleSet(sheet);
    ASSERT_LT(set.bounds.lo.z, set.bounds.hi.z);
    ASSERT_LT(set.bounds.hi.z - set.bounds.lo.z, kSmallestNormal);
    for (const auto build : {buildSpatialMedian, buildObjectMedian}) {
        const KdTree tree = build(set, {}, nullptr);
        EXPECT_GT(tree.nodes.size(), 100u);
        for (const KdNode& node : tree.nodes) EXPECT_NE(nodeAxis(node), 2u);
    }
}

// Cubes at y = 0 and 5: Bentley's first axis is x, the longest y; the cheapest cut leaves each cube whole, so y again.
TEST(BuildMedian, AxesAreChosenAsAsked) {
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>{unitAt({0, 0, 0}), unitAt({0, 5, 0})});
    for (const auto build : {buildSpatialMedian, buildObjectMedian}) {
        EXPECT_EQ(nodeAxis(build(set, stopAt(1, AxisChoice::cycle), nullptr).nodes[0]), 0u);
        EXPECT_EQ(nodeAxis(build(set, stopAt(1, AxisChoice::widest), nullptr).nodes[0]), 1u);
    }
    EXPECT_EQ(nodeAxis(buildSpatialMedian(set, stopAt(1, AxisChoice::all)).nodes[0]), 1u);
}

TEST(BuildMedian, CyclesWithTheLevelAndSkipsFlatAxes) {
    std::vector<Triangle> flat;
    for (const Triangle& t : test::soup(4, 200, 0.01f))
        flat.push_back({{t.a.x, t.a.y, 0}, {t.b.x, t.b.y, 0}, {t.c.x, t.c.y, 0}});
    const TriangleSet set = makeTriangleSet(flat);
    for (const auto build : {buildSpatialMedian, buildObjectMedian}) {
        const KdTree tree = build(set, {}, nullptr);
        uint32_t node = 0;
        for (const uint32_t axis : {0u, 1u, 0u, 0u}) {  // the third level would be z's
            ASSERT_NE(nodeAxis(tree.nodes[node]), kLeafAxis);
            EXPECT_EQ(nodeAxis(tree.nodes[node]), axis);
            node = nodeChild(tree.nodes[node]);
        }
    }
}

TEST(BuildMedian, StopsAtTheLeafSize) {
    std::vector<Triangle> apart;  // no two boxes share a plane, so that every set can be halved
    for (uint32_t i = 0; i < 512; ++i) apart.push_back(unitAt(vec3(2.0f) * vec3(i % 8, i / 8 % 8, i / 64)));
    const TriangleSet set = makeTriangleSet(apart);
    for (const uint32_t leafSize : {1u, 8u}) {
        const KdTree tree = buildSpatialMedian(set, stopAt(leafSize));
        EXPECT_EQ(computeStatistics(tree).largestLeaf, leafSize);
        EXPECT_EQ(computeStatistics(tree).references, 512u);
    }
    EXPECT_LT(computeStatistics(buildObjectMedian(set, stopAt(8))).nodes,
              computeStatistics(buildObjectMedian(set, stopAt(2))).nodes);
}

// Triangles that all reach through the cell: without an end to copying, 400 would fill 2^19 leaves.
TEST(BuildMedian, CopiesReferencesAtMostSixteenTimes) {
    for (const auto& triangles : {std::vector<Triangle>(400, unitAt({0, 0, 0})), test::soup(5, 400, 3.0f)}) {
        const TriangleSet set = makeTriangleSet(triangles);
        for (const auto build : {buildSpatialMedian, buildObjectMedian})
            for (const AxisChoice axes : {AxisChoice::cycle, AxisChoice::widest, AxisChoice::all}) {
                const KdTree tree = build(set, stopAt(1, axes), nullptr);
                EXPECT_LE(computeStatistics(tree).references, 16u * 400u);
                EXPECT_GT(tree.nodes.size(), 1u);
                EXPECT_TRUE(validate(tree, set, depthLimit(BuildSettings{}, 400)).ok());
            }
    }
}

TEST(BuildMedian, KeepsToTheDepthAsked) {
    const TriangleSet set = makeTriangleSet(test::soup(6, 1000, 0.02f));
    BuildSettings settings = stopAt(1);
    settings.maxDepth = 5;
    for (const auto build : {buildSpatialMedian, buildObjectMedian})
        EXPECT_EQ(computeStatistics(build(set, settings, nullptr)).maxDepth, 5u);
}

}  // namespace
}  // namespace cleave
