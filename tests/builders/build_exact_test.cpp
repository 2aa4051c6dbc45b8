#include <gtest/gtest.h>

#include <algorithm>

#include "builders/builders.h"
#include "judge/validate.h"
#include "measure/statistics.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

// A triangle whose box is the unit cube, moved along x.
Triangle unitAt(float x) { return {{x, 0, 0}, {x + 1, 1, 0}, {x + 0.5f, 0.5f, 1}}; }

std::vector<uint32_t> listOf(const KdTree& tree, uint32_t node) {
    const auto begin = tree.leafTriangles.begin() + leafFirst(tree.nodes[node]);
    return {begin, begin + leafCount(tree.nodes[node])};
}

// Box 4 x 1 x 1, half area 9; a leaf costs 20 * 2 * 9 = 360. Planes x = 1 and x = 3 cost 15 * 9 + 20 * (3 + 7) = 335;
// the lower wins. Its right child, 3 x 1 x 1 with half area 7, costs 140 as a leaf; cutting off the empty part at x = 3
// costs 0.8 * (15 * 7 + 20 * 3) = 132. Cost of the tree: 15 * (1 + 7 / 9) + 20 * (3 / 9 + 3 / 9) = 40.
TEST(BuildExact, TwoTrianglesWorkedByHand) {
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>{unitAt(0), unitAt(3)});
    const KdTree tree = buildExact(set, {});
    ASSERT_EQ(tree.nodes.size(), 5u);
    EXPECT_EQ(set.exponent, 3);
    EXPECT_EQ(nodeAxis(tree.nodes[0]), 0u);
    EXPECT_EQ(nodePosition(tree.nodes[0]), 0.125f);
    EXPECT_EQ(listOf(tree, 1), std::vector<uint32_t>{0});
    EXPECT_EQ(nodeAxis(tree.nodes[2]), 0u);
    EXPECT_EQ(nodePosition(tree.nodes[2]), 0.375f);
    EXPECT_EQ(leafCount(tree.nodes[3]), 0u);
    EXPECT_EQ(listOf(tree, 4), std::vector<uint32_t>{1});
    EXPECT_DOUBLE_EQ(computeStatistics(tree).sahCost.value(), 40.0);
}

// A sheet in the plane between two cubes: left or right costs the same, 15 * 5 + 20 * (3 * 2 + 3) = 255 < 300, so left.
TEST(BuildExact, PlanarTriangleGoesLeftOnTies) {
    const Triangle sheet{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
    const KdTree tree = buildExact(makeTriangleSet(std::vector<Triangle>{unitAt(0), sheet, unitAt(1)}), {});
    ASSERT_EQ(tree.nodes.size(), 3u);
    EXPECT_EQ(listOf(tree, 1), (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(listOf(tree, 2), std::vector<uint32_t>{2});
}

// The sheet at x = 1 of [0, 4]: left, 15 * 9 + 20 * (3 * 2 + 7) = 395; right, 135 + 20 * (3 + 7 * 2) = 475; leaf, 540.
TEST(BuildExact, PlanarTriangleGoesToTheCheaperSide) {
    const Triangle sheet{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
    const KdTree tree = buildExact(makeTriangleSet(std::vector<Triangle>{unitAt(0), sheet, unitAt(3)}), {});
    EXPECT_EQ(nodePosition(tree.nodes[0]), 0.125f);
    EXPECT_EQ(listOf(tree, nodeChild(tree.nodes[0])), (std::vector<uint32_t>{0, 1}));
    const Triangle mirrored{{3, 0, 0}, {3, 1, 0}, {3, 0, 1}};
    const KdTree other = buildExact(makeTriangleSet(std::vector<Triangle>{unitAt(0), mirrored, unitAt(3)}), {});
    EXPECT_EQ(nodePosition(other.nodes[0]), 0.375f);
    EXPECT_EQ(listOf(other, nodeChild(other.nodes[0]) + 1), (std::vector<uint32_t>{1, 2}));
}

TEST(BuildExact, SettingsAreHonoured) {
    const TriangleSet set = makeTriangleSet(test::soup(1, 400, 0.2f));
    BuildSettings settings;
    settings.maxDepth = 4;
    const KdTree shallow = buildExact(set, settings);
    EXPECT_EQ(computeStatistics(shallow).maxDepth, 4u);
    settings = {};
    settings.clip = false;
    const KdTree unclipped = buildExact(set, settings);
    const ValidationReport report = validate(unclipped, set, depthLimit(settings, 400));
    EXPECT_TRUE(report.ok());
    EXPECT_GT(report.surplusReferences, 0u) << "unclipped boxes reach into cells that their triangles miss";
    EXPECT_LT(*computeStatistics(buildExact(set, {})).sahCost, *computeStatistics(unclipped).sahCost);
}

TEST(BuildExact, OfNothingIsAnEmptyLeaf) {
    const TriangleSet set = makeTriangleSet({});
    for (const KdTree& tree : {buildExact(set, {}), buildBrute(set)}) {
        ASSERT_EQ(tree.nodes.size(), 1u);
        EXPECT_EQ(leafCount(tree.nodes[0]), 0u);
        EXPECT_TRUE(isEmpty(tree.bounds));
        EXPECT_TRUE(validate(tree, set, 0).ok());
    }
}

}  // namespace
}  // namespace cleave
