#include "shared/sah.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace cleave {
namespace {

const Box kCell{{0, 0, 0}, {10, 4, 2}};  // half its surface: 40 + 8 + 20 = 68

Split splitAt(float cost, uint axis, float position, uint planarLeft) { return {cost, axis, position, planarLeft}; }

TEST(Sah, halfAreaAddsThreeFaces) {
    EXPECT_EQ(halfArea({10, 4, 2}), 68.0f);
    EXPECT_EQ(halfArea({3, 0, 0}), 0.0f);
    EXPECT_EQ(halfArea({3, 2, 0}), 6.0f);
    EXPECT_EQ(halfArea({1e-20f, 1e-20f, 1e-20f}), 0.0f) << "denormal products count as zero";
}

TEST(Sah, costsAreAreasTimesCounts) {
    EXPECT_EQ(leafCost(kDefaultCosts, kCell, 7u), 20.0f * 7.0f * 68.0f);
    EXPECT_EQ(leafCost(kDefaultCosts, kCell, 0u), 0.0f);
    // x = 3: left 3 x 4 x 2 has 12 + 8 + 6 = 26, right 7 x 4 x 2 has 28 + 8 + 14 = 50.
    EXPECT_EQ(splitCost(kDefaultCosts, kCell, 0u, 3.0f, 5u, 2u), 15.0f * 68.0f + 20.0f * (26.0f * 5.0f + 50.0f * 2.0f));
    // y = 1: left 10 x 1 x 2 has 32, right 10 x 3 x 2 has 56. z = 1.5: 10 x 4 x 1.5 has 61, 10 x 4 x 0.5 has 47.
    EXPECT_EQ(splitCost(kDefaultCosts, kCell, 1u, 1.0f, 3u, 4u), 15.0f * 68.0f + 20.0f * (32.0f * 3.0f + 56.0f * 4.0f));
    EXPECT_EQ(splitCost(kDefaultCosts, kCell, 2u, 1.5f, 1u, 1u), 15.0f * 68.0f + 20.0f * (61.0f + 47.0f));
}

// The halves of the cell have 26 + 50 at x = 3, whatever is in them; a leaf has the cell's 68.
TEST(Sah, leavesCostByTheirAreas) {
    const SahCosts costs{15.0f, 20.0f, 6.0f, 0.5f};
    EXPECT_EQ(leafCost(costs, kCell, 7u), 20.0f * 7.0f * 68.0f + 6.0f * 68.0f);
    EXPECT_EQ(leafCost(costs, kCell, 0u), 6.0f * 68.0f);
    const float halves = 15.0f * 68.0f + 6.0f * (26.0f + 50.0f);
    EXPECT_EQ(splitCost(costs, kCell, 0u, 3.0f, 5u, 2u), halves + 20.0f * (26.0f * 5.0f + 50.0f * 2.0f));
    EXPECT_EQ(splitCost(costs, kCell, 0u, 3.0f, 0u, 2u), 0.5f * (halves + 20.0f * 50.0f * 2.0f)) << "and the bonus";
    const SahCosts none{15.0f, 20.0f, 6.0f, 1.0f};
    EXPECT_EQ(splitCost(none, kCell, 0u, 3.0f, 0u, 2u), halves + 20.0f * 50.0f * 2.0f) << "no bonus";
}

TEST(Sah, costsDependOnExtentsOnly) {
    const Box moved{{-6, 32, 64}, {4, 36, 66}};
    EXPECT_EQ(splitCost(kDefaultCosts, moved, 0u, -3.0f, 5u, 2u), splitCost(kDefaultCosts, kCell, 0u, 3.0f, 5u, 2u));
    EXPECT_EQ(leafCost(kDefaultCosts, moved, 3u), leafCost(kDefaultCosts, kCell, 3u));
}

TEST(Sah, emptySidesAreCheaper) {
    EXPECT_EQ(splitCost(kDefaultCosts, kCell, 0u, 3.0f, 0u, 2u), 0.8f * (15.0f * 68.0f + 20.0f * 50.0f * 2.0f));
    EXPECT_EQ(splitCost(kDefaultCosts, kCell, 0u, 3.0f, 5u, 0u), 0.8f * (15.0f * 68.0f + 20.0f * 26.0f * 5.0f));
    EXPECT_EQ(splitCost(kDefaultCosts, kCell, 0u, 3.0f, 0u, 0u), 0.8f * 15.0f * 68.0f);
}

TEST(Sah, candidatesHaveATotalOrder) {
    const std::vector<Split> ascending = {splitAt(1, 2, 9, 0), splitAt(2, 0, 9, 0), splitAt(2, 1, 3, 0),
                                          splitAt(2, 1, 4, 1), splitAt(2, 1, 4, 0), noSplit()};
    for (size_t i = 0; i < ascending.size(); i++)
        for (size_t j = 0; j < ascending.size(); j++)
            EXPECT_EQ(isBetter(ascending[i], ascending[j]), i < j) << i << " " << j;
}

TEST(Sah, keepsTheBetterOfTwo) {
    const Split first = betterOf(noSplit(), kDefaultCosts, kCell, 0u, 3.0f, 5u, 2u, 0u);
    EXPECT_EQ(first.cost, splitCost(kDefaultCosts, kCell, 0u, 3.0f, 5u, 2u));
    EXPECT_EQ(first.axis, 0u);
    EXPECT_EQ(first.position, 3.0f);
    EXPECT_EQ(first.planarLeft, 0u);
    EXPECT_EQ(betterOf(first, kDefaultCosts, kCell, 0u, 3.0f, 6u, 2u, 1u).planarLeft, 0u) << "dearer";
    EXPECT_EQ(betterOf(first, kDefaultCosts, kCell, 0u, 3.0f, 5u, 2u, 1u).planarLeft, 1u) << "as dear, but planar left";
    EXPECT_EQ(betterOf(first, kDefaultCosts, kCell, 0u, 3.0f, 4u, 2u, 1u).planarLeft, 1u) << "cheaper";
}

TEST(Sah, planesLieStrictlyInside) {
    for (uint axis = 0; axis < 3; axis++) {
        const float hi = kCell.hi[static_cast<int>(axis)];
        for (const float outside : {-1.0f, 0.0f, hi, hi + 1.0f, std::numeric_limits<float>::quiet_NaN()})
            EXPECT_EQ(betterOf(noSplit(), kDefaultCosts, kCell, axis, outside, 1u, 1u, 1u).axis, kLeafAxis)
                << axis << " " << outside;
        for (const float inside : {nextFloat(0.0f, true), 1.0f, nextFloat(hi, false)})
            EXPECT_EQ(betterOf(noSplit(), kDefaultCosts, kCell, axis, inside, 1u, 1u, 1u).axis, axis) << inside;
    }
}

TEST(Sah, planarReferencesAreTriedOnBothSides) {
    // Behind x = 3 all is larger than before it, so planar ones go left; at x = 7 right.
    Split s = betterOfBothSides(noSplit(), kDefaultCosts, kCell, 0u, 3.0f, 2u, 2u, 3u);
    EXPECT_EQ(s.planarLeft, 1u);
    EXPECT_EQ(s.cost, splitCost(kDefaultCosts, kCell, 0u, 3.0f, 5u, 2u));
    s = betterOfBothSides(noSplit(), kDefaultCosts, kCell, 0u, 7.0f, 2u, 2u, 3u);
    EXPECT_EQ(s.planarLeft, 0u);
    EXPECT_EQ(s.cost, splitCost(kDefaultCosts, kCell, 0u, 7.0f, 2u, 5u));
    EXPECT_EQ(betterOfBothSides(noSplit(), kDefaultCosts, kCell, 0u, 5.0f, 2u, 2u, 3u).planarLeft, 1u) << "equal: left";
    EXPECT_EQ(betterOfBothSides(noSplit(), kDefaultCosts, kCell, 0u, 7.0f, 2u, 2u, 0u).planarLeft, 1u) << "none: left";
}

TEST(Sah, splitsOnlyWhatIsWorthwhile) {
    const float leaf = leafCost(kDefaultCosts, kCell, 3u);
    EXPECT_FALSE(isWorthwhile(kDefaultCosts, splitAt(leaf, 0, 1, 1), kCell, 3u, 0u, 10u)) << "as dear as a leaf";
    EXPECT_TRUE(isWorthwhile(kDefaultCosts, splitAt(nextFloat(leaf, false), 0, 1, 1), kCell, 3u, 0u, 10u));
    EXPECT_FALSE(isWorthwhile(kDefaultCosts, noSplit(), kCell, 3u, 0u, 10u));
    EXPECT_TRUE(isWorthwhile(kDefaultCosts, splitAt(0, 0, 1, 1), kCell, 3u, 9u, 10u));
    EXPECT_FALSE(isWorthwhile(kDefaultCosts, splitAt(0, 0, 1, 1), kCell, 3u, 10u, 10u)) << "at the cap";
    EXPECT_TRUE(isWorthwhile(kDefaultCosts, splitAt(0, 0, 1, 1), {{0, 0, 0}, {10, 4, 0}}, 3u, 0u, 10u)) << "flat";
    EXPECT_FALSE(isWorthwhile(kDefaultCosts, splitAt(-1, 0, 1, 1), {{0, 0, 0}, {10, 0, 0}}, 3u, 0u, 10u)) << "a line";
}

TEST(Sah, sideOfForEveryRelation) {
    for (const uint planarLeft : {0u, 1u}) {
        EXPECT_EQ(sideOf(1, 2, 5, planarLeft), kLeft);
        EXPECT_EQ(sideOf(1, 5, 5, planarLeft), kLeft) << "ends at the plane";
        EXPECT_EQ(sideOf(1, 9, 5, planarLeft), kLeft | kRight);
        EXPECT_EQ(sideOf(5, 9, 5, planarLeft), kRight) << "begins at the plane";
        EXPECT_EQ(sideOf(7, 9, 5, planarLeft), kRight);
        EXPECT_EQ(sideOf(2, 2, 5, planarLeft), kLeft) << "flat before the plane";
        EXPECT_EQ(sideOf(7, 7, 5, planarLeft), kRight) << "flat behind the plane";
        EXPECT_EQ(sideOf(5, 5, 5, planarLeft), planarLeft != 0u ? kLeft : kRight) << "in the plane";
        EXPECT_EQ(sideOf(-0.0f, 0.0f, 0.0f, planarLeft), planarLeft != 0u ? kLeft : kRight);
    }
}

struct Interval {
    float lo;
    float hi;
};

// What a builder counts is what classification then does: the cost of the chosen split is that of the sides.
TEST(Sah, costOfASplitIsThatOfItsSides) {
    int wentRight = 0;
    for (uint seed = 0; seed < 3000; seed++) {
        std::mt19937 random(seed);
        std::vector<Interval> refs;
        for (uint i = 0; i < 1 + seed % 12; i++) {
            const float lo = static_cast<float>(random() % 11);
            refs.push_back({lo, min(10.0f, lo + static_cast<float>(random() % 4))});
        }
        for (int p = 1; p < 10; p++) {
            const float plane = static_cast<float>(p);
            uint left = 0, right = 0, planar = 0, sides[2] = {0, 0};
            for (const auto& r : refs) {
                left += r.lo < plane ? 1u : 0u;
                right += r.hi > plane ? 1u : 0u;
                planar += r.lo == plane && r.hi == plane ? 1u : 0u;
            }
            const Split s = betterOfBothSides(noSplit(), kDefaultCosts, kCell, 0u, plane, left, right, planar);
            for (const auto& r : refs) {
                const uint side = sideOf(r.lo, r.hi, s.position, s.planarLeft);
                ASSERT_NE(side, 0u);
                sides[0] += side & kLeft;
                sides[1] += (side & kRight) >> 1;
            }
            ASSERT_EQ(s.cost, splitCost(kDefaultCosts, kCell, 0u, plane, sides[0], sides[1]))
                << "seed " << seed << " at " << plane;
            wentRight += s.planarLeft == 0u ? 1 : 0;
        }
    }
    EXPECT_GT(wentRight, 1000);
}

}  // namespace
}  // namespace cleave
