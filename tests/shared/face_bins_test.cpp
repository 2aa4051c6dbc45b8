#include "shared/face_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cleave {
namespace {

// Cells as trees have them: of all sizes, near the origin and far from it, some flat or a few floats wide.
class Cells {
  public:
    Box next() {
        Box cell;
        for (int axis = 0; axis < 3; axis++) {
            const float lo = near(0.0f, -30);
            cell.lo[axis] = lo;
            cell.hi[axis] = std::max(lo, near(lo, -30));
            if (pick(8) == 0) cell.hi[axis] = lo;
            if (pick(8) == 0) cell.hi[axis] = nextFloat(nextFloat(lo, true), true);
        }
        return cell;
    }
    // From lo to hi, either included now and then.
    float between(float lo, float hi) {
        if (pick(6) == 0) return pick(2) == 0 ? lo : hi;
        return std::clamp(lo + (hi - lo) * std::uniform_real_distribution<float>(0.0f, 1.0f)(random_), lo, hi);
    }
    // Of references: none, a few or many.
    uint32_t count() { return pick(3) == 0 ? 0 : pick(1u << pick(27)); }
    SahCosts costs() {
        const SahCosts rules[] = {
            kDefaultCosts, {0.0f, 20.0f, 0.0f, 0.8f}, {15.0f, 20.0f, 7.5f, 1.0f}, {1.0f, 3.0f, 0.3f, 0.001f}};
        return rules[pick(std::size(rules))];
    }
    uint32_t pick(uint32_t below) { return std::uniform_int_distribution<uint32_t>(0, below - 1)(random_); }

  private:
    std::mt19937 random_{7};

    float near(float x, int least) {
        const float unit = std::uniform_real_distribution<float>(-0.7f, 0.7f)(random_);
        return std::clamp(x + std::ldexp(unit, std::uniform_int_distribution<int>(least, 0)(random_)), -0.9f, 0.9f);
    }
};

constexpr uint32_t kReferences[] = {1, 161, 1024, 1025, 5000, 300'000, 1u << 30};

TEST(FaceBins, areAsManyAsChunksHaveCountersFor) {
    for (const uint32_t references : kReferences) {
        const uint32_t capacity = faceBinCapacity(references);
        const uint32_t counters = ceilDiv(references, kChunk) * 6 * kBins;
        EXPECT_LE(uint64_t{6} * capacity, counters) << references;
        EXPECT_TRUE(12 * uint64_t{capacity} > counters || capacity == kMostFaceBins) << references;
    }
}

TEST(FaceBins, holdTheirFacesInOrder) {
    Cells cells;
    for (int i = 0; i < 20'000; i++) {
        const Box cell = cells.next();
        const uint32_t capacity = faceBinCapacity(kReferences[cells.pick(std::size(kReferences))]);
        const uint32_t axis = cells.pick(3);
        const FaceBins bins = faceBins(cell, axis, capacity);
        ASSERT_GE(bins.count, 1u);
        ASSERT_LE(bins.count, capacity);
        ASSERT_EQ(faceBinEdge(bins, 0), bins.lo);
        ASSERT_EQ(faceBinEdge(bins, bins.count), bins.hi);
        // Anywhere, and at the edges of bins and beside them, where rounding shows.
        std::vector<float> faces;
        for (int k = 0; k < 10; k++) {
            faces.push_back(cells.between(bins.lo, bins.hi));
            const float edge = faceBinEdge(bins, cells.pick(bins.count + 1));
            for (const float x : {edge, nextFloat(edge, true), nextFloat(edge, false)})
                faces.push_back(std::clamp(x, bins.lo, bins.hi));
        }
        std::sort(faces.begin(), faces.end());
        uint32_t before = 0;
        for (const float x : faces) {
            const uint32_t b = faceBinOf(bins, x);
            ASSERT_LT(b, bins.count);
            ASSERT_LE(faceBinEdge(bins, b), x);
            ASSERT_LE(x, faceBinEdge(bins, b + 1));
            ASSERT_LE(before, b);
            before = b;
        }
    }
}

// A wide cell's bins are used: at least every other one of those that there is room for.
TEST(FaceBins, areNarrowEnough) {
    Cells cells;
    for (int i = 0; i < 1000; i++) {
        const Box cell = cells.next();
        const FaceBins bins = faceBins(cell, 0, 1024);
        if (cell.hi.x - cell.lo.x < kSmallestNormal) continue;
        EXPECT_GT(bins.count, 512u);
    }
}

// Whatever a plane in a bin has on its sides, its rounded cost is not below the bound.
TEST(FaceBins, boundTheRoundedCostOfPlanesFromBelow) {
    Cells cells;
    uint32_t tight = 0;
    for (int i = 0; i < 200'000; i++) {
        const Box cell = cells.next();
        const uint32_t axis = cells.pick(3);
        const SahCosts costs = cells.costs();
        const FaceBins bins = faceBins(cell, axis, faceBinCapacity(kReferences[cells.pick(5)]));
        const uint32_t b = cells.pick(bins.count);
        const float x = cells.between(faceBinEdge(bins, b), faceBinEdge(bins, b + 1));
        const uint32_t before = cells.count(), after = cells.count();
        const float cost = splitCost(costs, cell, axis, x, before + cells.count(), after + cells.count());
        const float least = leastCost(costs, cell, axis, bins, b, before, after);
        ASSERT_LE(least, cost) << i;
        tight += least * (1.0f + 4.0f * kCostMargin) >= cost;
    }
    EXPECT_GT(tight, 1000u) << "the bound is never near";
}

// Of two planes on either side of a bin's begin, with no more on their sides than it has, one costs no more than the
// bound.
TEST(FaceBins, boundTheRoundedCostOfABestPlaneFromAbove) {
    Cells cells;
    uint32_t tight = 0;
    for (int i = 0; i < 200'000; i++) {
        const Box cell = cells.next();
        const uint32_t axis = cells.pick(3);
        const SahCosts costs = cells.costs();
        const FaceBins bins = faceBins(cell, axis, faceBinCapacity(kReferences[cells.pick(5)]));
        const uint32_t b = cells.pick(bins.count);
        const float edge = faceBinEdge(bins, b);
        const float below = cells.between(bins.lo, edge), above = cells.between(edge, bins.hi);
        const uint32_t left = cells.count(), right = cells.count();
        const auto costAt = [&](float x) {
            return splitCost(costs, cell, axis, x, left - cells.pick(left + 1), right - cells.pick(right + 1));
        };
        const float cost = std::min(costAt(below), costAt(above));
        const float most = mostCost(costs, cell, axis, bins, b, left, right);
        ASSERT_LE(cost, most) << i;
        tight += cost * (1.0f + 4.0f * kCostMargin) >= most;
    }
    EXPECT_GT(tight, 1000u) << "the bound is never near";
}

TEST(FaceBins, knowWhereACandidateIsOnEitherSide) {
    const FaceBins bins = faceBins({{-1, 0, 0}, {1, 1, 1}}, 0, 32);
    EXPECT_TRUE(isBetweenCandidates(bins, 5, 1, 1));
    EXPECT_FALSE(isBetweenCandidates(bins, 5, 0, 1));
    EXPECT_FALSE(isBetweenCandidates(bins, 5, 1, 0));
    EXPECT_FALSE(isBetweenCandidates(bins, 0, 1, 1));
    EXPECT_FALSE(isBetweenCandidates(bins, bins.count, 1, 1));
}

TEST(FaceBins, haveMarginsThatArePowersOfTwo) {
    EXPECT_EQ(kCostMargin, 0x1p-18f);
    EXPECT_EQ(kFlushedMargin, 0x1p-80f);
}

}  // namespace
}  // namespace cleave
