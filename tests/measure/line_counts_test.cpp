#include "measure/line_counts.h"

#include <gtest/gtest.h>

namespace cleave::test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A unit cube in a world twice as large as the tree's space, cut at x = 0.5, its right half at y = 0.25; leaves list 1,
// 2 and 0 triangles. In the world all lengths are twice as long.
KdTree threeCells() {
    KdTree tree;
    tree.bounds = {vec3(0), vec3(1)};
    tree.exponent = 1;
    tree.nodes = {innerNode(0, 0.5f, 1), leafNode(0, 1), innerNode(1, 0.25f, 3), leafNode(1, 2), leafNode(3, 0)};
    tree.leafTriangles = {0, 1, 2};
    return tree;
}

LineCounts along(vec3 origin, vec3 direction, double from, double to) {
    LineCounts counts;
    countAlong(threeCells(), {origin, 0.0f, direction, 1e30f}, from, to, counts);
    return counts;
}

void expectMet(const LineCounts& met, uint64_t inner, uint64_t leaves, uint64_t triangles) {
    EXPECT_EQ(met.lines, 1u);
    EXPECT_EQ(met.inner, inner);
    EXPECT_EQ(met.leaves, leaves);
    EXPECT_EQ(met.triangles, triangles);
}

TEST(LineCounts, OfAxisParallelLines) {
    expectMet(along({-1, 0.2f, 1}, {1, 0, 0}, 0, kInfinite), 2, 2, 3);     // left, then below y = 0.5 of the world
    expectMet(along({-1, 1.2f, 1}, {1, 0, 0}, 0, kInfinite), 2, 2, 1);     // left, then above
    expectMet(along({0.2f, -1, 1}, {0, 1, 0}, 0, kInfinite), 1, 1, 1);     // left alone
    expectMet(along({1.8f, 3, 1}, {0, -1, 0}, 0, kInfinite), 2, 2, 2);     // right, both
    expectMet(along({1.8f, 3, 2.5f}, {0, -1, 0}, 0, kInfinite), 0, 0, 0);  // beside the cube
}

TEST(LineCounts, OfPartsOfALine) {
    const vec3 origin(-1, 0.2f, 1), direction(1, 0, 0);  // in the cube from t = 1 to 3, through the plane at 2
    expectMet(along(origin, direction, 0, 0.5), 0, 0, 0);
    expectMet(along(origin, direction, 0, 1.5), 1, 1, 1);
    expectMet(along(origin, direction, 0, 2.5), 2, 2, 3);
    expectMet(along(origin, direction, 2.5, kInfinite), 2, 1, 2);
    expectMet(along(origin, direction, 2.5, 2.5), 2, 1, 2);
    expectMet(along(origin, direction, 3.5, kInfinite), 0, 0, 0);
}

TEST(LineCounts, OfSlantedLinesWhateverTheirLength) {
    for (const float length : {1.0f, 8.0f, 0.125f})
        expectMet(along({0, 0, 0}, vec3(1, 1, 1) * length, 0, kInfinite), 2, 2, 1);  // right of x = 1 at y = 1
}

TEST(LineCounts, AsCosts) {
    LineCounts counts;
    EXPECT_FALSE(counts.cost(kDefaultCosts));
    counts.lines = 4;
    counts.inner = 8;
    counts.leaves = 12;
    counts.triangles = 2;
    EXPECT_EQ(counts.perLine(counts.leaves), 3.0);
    SahCosts costs = kDefaultCosts;
    costs.leaf = 4.0f;
    EXPECT_EQ(counts.cost(costs), 15.0 * 2.0 + 4.0 * 3.0 + 20.0 * 0.5);
}

}  // namespace
}  // namespace cleave::test
