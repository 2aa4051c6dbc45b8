#include "measure/leaf_reasons.h"

#include <gtest/gtest.h>

#include "builders/builder_names.h"
#include "builders/builders.h"
#include "measure/statistics.h"
#include "support/small_scenes.h"

namespace cleave::test {
namespace {

uint64_t sumOf(const LeafReasons& r) {
    return r.empty + r.depthLimit + r.collapsedAxes + r.identicalBoxes + r.noPlane + r.cost + r.wouldPay;
}

KdTree oneLeaf(const TriangleSet& set) { return buildBrute(set); }

LeafReasons reasonsOf(const std::vector<Triangle>& triangles, const BuildSettings& settings = {}) {
    const TriangleSet set = makeTriangleSet(triangles);
    return countLeafReasons(oneLeaf(set), set, settings);
}

constexpr Triangle kSmall{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(LeafReasons, tellsWhyOneLeafIsALeaf) {
    EXPECT_EQ(reasonsOf({}).empty, 1u);
    EXPECT_EQ(reasonsOf({kSmall}).noPlane, 1u) << "its box is the cell";
    EXPECT_EQ(reasonsOf({kSmall, kSmall}).identicalBoxes, 1u);

    BuildSettings shallow;
    shallow.maxDepth = 1;
    TriangleSet set = makeTriangleSet(integerSoup(1, 50, 4));
    const LeafReasons shallowReasons = countLeafReasons(buildExact(set, shallow), set, shallow);
    EXPECT_EQ(shallowReasons.depthLimit, 2u);
    EXPECT_EQ(sumOf(shallowReasons), 2u);

    // Two and two far apart: to cut them apart pays. One beside the other: it does not.
    const Triangle far = {kSmall.a + vec3(99), kSmall.b + vec3(99), kSmall.c + vec3(99)};
    EXPECT_EQ(reasonsOf({kSmall, kSmall, far, far}).wouldPay, 1u);
    const Triangle near = {{0.5f, 0, 0.25f}, {1, 0, 0.25f}, {0.5f, 1, 0.25f}};
    EXPECT_EQ(reasonsOf({kSmall, near}).cost, 1u);

    // A cell that is a line, which no scene with area has, but a tree may.
    set = makeTriangleSet(std::vector{kSmall});
    KdTree line = oneLeaf(set);
    line.bounds.hi = vec3(line.bounds.hi.x, 0, 0);
    EXPECT_EQ(countLeafReasons(line, set, {}).collapsedAxes, 1u);
}

// Exact SAH never stops where a split would pay, since it looks at every face; and every leaf has a reason.
TEST(LeafReasons, exactTreesStopForGoodReasons) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        const TriangleSet set =
            makeTriangleSet(seed % 2 == 0 ? integerSoup(seed, 300, 6) : soup(seed, 300, seed % 3 == 0 ? 0.5f : 0.05f));
        for (const TreeBuilder& builder : cpuBuilders()) {
            SCOPED_TRACE(std::string(builder.name) + ", seed " + std::to_string(seed));
            const KdTree tree = builder.build(set, {}).tree;
            const LeafReasons reasons = countLeafReasons(tree, set, {});
            const TreeStatistics statistics = computeStatistics(tree);
            EXPECT_EQ(sumOf(reasons), statistics.leaves);
            EXPECT_EQ(reasons.empty, statistics.emptyLeaves);
            if (builder.name.starts_with("exact")) {
                EXPECT_EQ(reasons.wouldPay, 0u);
            }
            if (builder.name == "brute" && seed % 6 == 1) {  // 300 small triangles in a leaf
                EXPECT_EQ(reasons.wouldPay, 1u);
            }
        }
    }
}

TEST(LeafReasons, aMedianBuilderStopsAtItsLeafSize) {
    const TriangleSet set = makeTriangleSet(soup(5, 400, 0.02f));
    BuildSettings large;
    large.leafSize = 64;
    EXPECT_GT(countLeafReasons(buildSpatialMedian(set, large), set, large).wouldPay, 0u);
}

}  // namespace
}  // namespace cleave::test
