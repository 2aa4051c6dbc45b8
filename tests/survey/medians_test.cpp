// Survey, section 4: "the object median algorithm has the same performance as the spatial median" (of MacDonald and
// Booth 1990). By the heuristic its trees cost more, under every rule of axes and at every leaf size; on surfaces by a
// fifth at least, on small triangles that fill space evenly hardly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "builders/builders.h"
#include "measure/statistics.h"
#include "survey/survey_scenes.h"

namespace cleave {
namespace {

double costOf(const KdTree& tree) { return computeStatistics(tree).sahCost.value(); }

struct Ratios {
    double least = 1e30, most = 0.0;
};

// Of the costs of object to spatial medians, over axes and leaf sizes.
Ratios ratiosOf(const char* name, const std::vector<Triangle>& triangles) {
    const TriangleSet set = makeTriangleSet(triangles);
    Ratios ratios;
    for (const AxisChoice axes : {AxisChoice::all, AxisChoice::widest, AxisChoice::cycle})
        for (const uint32_t leafSize : {1u, 2u, 4u, 8u, 16u, 32u, 64u}) {
            BuildSettings settings;
            settings.axes = axes;
            settings.leafSize = leafSize;
            const double ratio = costOf(buildObjectMedian(set, settings)) / costOf(buildSpatialMedian(set, settings));
            ratios.least = std::min(ratios.least, ratio);
            ratios.most = std::max(ratios.most, ratio);
        }
    std::printf("%s: planes through the median object cost %.2f to %.2f times as much\n", name, ratios.least,
                ratios.most);
    return ratios;
}

TEST(Medians, AreNotAlikeOnSurfaces) {
    EXPECT_GT(ratiosOf("bumpy sphere", test::bumpySphere(60)).least, 1.2);
    EXPECT_GT(ratiosOf("turned grid", test::turnedGrid(100)).least, 1.2);
}

TEST(Medians, AreNearlyAlikeWhereSmallTrianglesFillSpace) {
    const Ratios ratios = ratiosOf("soup", test::soup(3, 20000, 0.02f));
    EXPECT_GT(ratios.least, 1.0);
    EXPECT_LT(ratios.least, 1.1);
}

}  // namespace
}  // namespace cleave
