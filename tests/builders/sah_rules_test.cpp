// The settings of the heuristic, in every builder that goes by it: costs, bonus and stop. Trees worked by hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "builders/builder_names.h"
#include "judge/oracle.h"
#include "judge/validate.h"
#include "measure/leaf_reasons.h"
#include "measure/statistics.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

// A triangle whose box is the unit cube, moved along x.
Triangle unitAt(float x) { return {{x, 0, 0}, {x + 1, 1, 0}, {x + 0.5f, 0.5f, 1}}; }

const std::string_view kSahBuilders[] = {"exact", "exact-nlog2n", "hunt-all", "hunt-hybrid", "hunt-one", "shevtsov"};

class SahRules : public testing::TestWithParam<std::string_view> {
  protected:
    KdTree build(const std::vector<Triangle>& triangles, const BuildSettings& settings) const {
        return cpuBuilder(GetParam()).build(makeTriangleSet(triangles), settings).tree;
    }
    size_t nodesOf(const std::vector<Triangle>& triangles, const BuildSettings& settings) const {
        return build(triangles, settings).nodes.size();
    }
};

// Unit cubes at x = 0 and 3. Half areas: the cell 9; cut at x = 1 it falls into 3 and 7, and the right part at x = 3
// into 5, empty, and 3. The root: 15 x 9 + 20 (3 + 7) = 335 for a leaf's 20 x 2 x 9 = 360; the right part: 15 x 7 + 20
// x 3 = 165, times the bonus, for 20 x 7 = 140.
const std::vector<Triangle> kApart = {unitAt(0), unitAt(3)};

TEST_P(SahRules, ALeafsCostCountsOnBothSides) {
    BuildSettings settings;
    EXPECT_EQ(nodesOf(kApart, settings), 5u);
    settings.costs.leaf = 24.0f;  // 335 + 24 (3 + 7) = 575 for 360 + 24 x 9 = 576
    EXPECT_EQ(nodesOf(kApart, settings), 5u);
    settings.costs.leaf = 25.0f;  // 585 for 585
    EXPECT_EQ(nodesOf(kApart, settings), 1u);
}

TEST_P(SahRules, TheBonusDecidesOnEmptySpace) {
    BuildSettings settings;
    settings.costs.emptyBonus = 0.84f;  // 138.6 for 140
    EXPECT_EQ(nodesOf(kApart, settings), 5u);
    settings.costs.emptyBonus = 0.85f;  // 140.25
    EXPECT_EQ(nodesOf(kApart, settings), 3u);
    settings.costs.emptyBonus = 1.0f;
    EXPECT_EQ(nodesOf(kApart, settings), 3u);
}

TEST_P(SahRules, ThePublishedCostHasALeafsCost) {
    BuildSettings settings;
    settings.costs.leaf = 6.0f;
    const KdTree tree = build(kApart, settings);
    ASSERT_EQ(tree.nodes.size(), 5u);
    // Inner nodes 9 and 7, leaves 3, 5 and 3, of which 5 is empty: the bonus is not in it.
    EXPECT_DOUBLE_EQ(computeStatistics(tree, settings.costs).sahCost.value(), (15.0 * 16 + 6.0 * 11 + 20.0 * 6) / 9);
    EXPECT_DOUBLE_EQ(computeStatistics(tree).sahCost.value(), (15.0 * 16 + 20.0 * 6) / 9);
}

// Cubes side by side, half areas 5 and 3 + 3: 16 x 5 + 20 x 6 = 200, as much as the leaf's 20 x 2 x 5. Equation 4.1: 3
// + 3 - 5 x 2 < 0.
TEST_P(SahRules, Equation41SplitsWhateverAVisitCosts) {
    const std::vector<Triangle> beside = {unitAt(0), unitAt(1)};
    BuildSettings settings;
    settings.costs.traverse = 16.0f;
    EXPECT_EQ(nodesOf(beside, settings), 1u);
    settings.stop = StopRule::equation41;
    EXPECT_EQ(nodesOf(beside, settings), 3u);
    settings.costs.traverse = settings.costs.leaf = 1000.0f;
    EXPECT_EQ(nodesOf(beside, settings), 3u);
}

// Two triangles that fill the cell but for a corner: two planes lie inside, and both children keep both.
TEST_P(SahRules, Equation41StopsWhereNothingShrinks) {
    const std::vector<Triangle> nested = {unitAt(0), {{0.25f, 0, 0}, {0.75f, 1, 0}, {0.5f, 0.5f, 1}}};
    BuildSettings settings;
    settings.stop = StopRule::equation41;
    // At x = 0.25: 1 + 0.25 x 2 = 1.5 with one triangle, 1 + 0.75 x 2 = 2.5 with two: 6.5, for 3 x 2 = 6.
    EXPECT_EQ(nodesOf(nested, settings), 1u);
}

// The stop and the costs decide how far a tree goes, never what rays find.
TEST_P(SahRules, TreesAreSoundUnderEveryRule) {
    const TriangleSet set = makeTriangleSet(test::soup(11, 1500, 0.04f));
    const TreeBuilder& builder = cpuBuilder(GetParam());
    uint64_t before = 0;
    for (int rule = 0; rule < 4; ++rule) {
        SCOPED_TRACE(rule);
        BuildSettings settings;
        settings.snap = rule % 2 == 0;
        settings.otherAxes = rule % 2 == 0;
        settings.smallNodes = rule % 2 == 0 ? SmallNodes::count : SmallNodes::sort;
        settings.costs.leaf = rule == 1 ? 12.0f : 0.0f;
        settings.costs.emptyBonus = rule == 2 ? 1.0f : 0.8f;
        settings.stop = rule == 3 ? StopRule::equation41 : StopRule::cost;
        const KdTree tree = builder.build(set, settings).tree;
        const ValidationReport report = validate(tree, set, depthLimit(settings, set.included.size()));
        EXPECT_TRUE(report.ok()) << report.errors.front();
        EXPECT_NE(tree.nodes.size(), before);
        before = tree.nodes.size();
        const LeafReasons reasons = countLeafReasons(tree, set, settings);
        if (GetParam().starts_with("exact")) {
            EXPECT_EQ(reasons.wouldPay, 0u);
        }
        for (const Ray& ray : test::raysAt(9, 100, -1.0f, 1.0f)) {
            const Hit expected = bruteForce(set, ray, Query::closest), hit = stackWalk(tree, set, ray, Query::closest);
            EXPECT_TRUE(hit.t == expected.t && hit.prim == expected.prim);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Cpu, SahRules, testing::ValuesIn(kSahBuilders), [](const auto& tested) {
    std::string name(tested.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace cleave
