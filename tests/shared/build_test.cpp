#include "shared/build.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace cleave {
namespace {

struct Interval {
    float lo;
    float hi;
};

// From a few ulps wide to wide, near to zero and far from it.
BinRange anyRange(std::mt19937& random) {
    const float lo = static_cast<float>(static_cast<int>(random() % 2001) - 1000) *
                     std::ldexp(1.0f, static_cast<int>(random() % 40) - 30);
    float hi = lo;
    if (random() % 2 == 0) {
        for (uint steps = static_cast<uint>(random() % 200); steps > 0; steps--) hi = nextFloat(hi, true);
    } else {
        hi += std::ldexp(1.0f + static_cast<float>(random() % 4096) / 4097.0f, static_cast<int>(random() % 40) - 20);
    }
    const uint count = random() % 2 == 0 ? kBins : 2u + static_cast<uint>(random() % 31);
    return binRange(lo, hi, count, 1.0f / static_cast<float>(count));
}

// Half of them exactly on a plane, the others next to one or anywhere.
float anyIn(const BinRange& r, std::mt19937& random) {
    float x = binPlane(r, static_cast<uint>(random() % (r.count + 1u)));
    if (random() % 4 == 0) x = nextFloat(x, random() % 2 == 0);
    if (random() % 4 == 0) x = r.lo + (r.hi - r.lo) * (static_cast<float>(random() >> 8) * 0x1p-24f);
    return min(max(x, r.lo), r.hi);
}

std::string text(const BinRange& r, float x) {
    std::ostringstream s;
    s << std::hexfloat << "range " << r.lo << " to " << r.hi << ", " << r.count << " bins, x " << x;
    return s.str();
}

TEST(Build, binIndexCountsPlanes) {
    std::mt19937 random(1);
    int resolved = 0;
    for (int i = 0; i < 50000; i++) {
        const BinRange r = anyRange(random);
        if (isResolved(r)) resolved++;
        for (int j = 0; j < 8; j++) {
            const float x = anyIn(r, random);
            uint before = 0, atOrBefore = 0;
            for (uint b = 1; b < r.count && isResolved(r); b++) {
                before += binPlane(r, b) < x ? 1u : 0u;
                atOrBefore += binPlane(r, b) <= x ? 1u : 0u;
            }
            ASSERT_EQ(binIndex(r, x, true), before) << text(r, x);
            ASSERT_EQ(binIndex(r, x, false), atOrBefore) << text(r, x);
        }
    }
    EXPECT_GT(resolved, 25000);
    EXPECT_LT(resolved, 48000);
}

TEST(Build, rangesTooNarrowForTheirBinsHaveNoPlanes) {
    EXPECT_TRUE(isResolved(binRange(0.0f, 1.0f, 32u, 1.0f / 32.0f)));
    EXPECT_FALSE(isResolved(binRange(1.0f, 1.0f, 32u, 1.0f / 32.0f)));
    EXPECT_FALSE(isResolved(binRange(1.0f, 1.0f + 0x1p-22f, 32u, 1.0f / 32.0f)));
    EXPECT_FALSE(isResolved(binRange(0.0f, kSmallestNormal, 2u, 0.5f))) << "its bins are denormal";
}

// What `bin` counts and `choose_split` adds up is what `classify` does at that plane.
TEST(Build, countersGiveTheCountsOfSideOf) {
    std::mt19937 random(2);
    for (int i = 0; i < 5000; i++) {
        const BinRange r = anyRange(random);
        if (!isResolved(r)) continue;
        uint starts[kBins] = {}, ends[kBins] = {};
        std::vector<Interval> refs;
        for (int k = 0; k < 30; k++) {
            const float x = anyIn(r, random);
            const float y = random() % 3 == 0 ? x : anyIn(r, random);
            refs.push_back({min(x, y), max(x, y)});
            starts[startBin(r, refs.back().lo, refs.back().hi)]++;
            ends[endBin(r, refs.back().hi)]++;
        }
        for (uint b = 1; b < r.count; b++) {
            uint left = 0, right = 0, isLeft = 0, isRight = 0;
            for (uint k = 0; k < b; k++) left += starts[k];
            for (uint k = b; k < r.count; k++) right += ends[k];
            for (const auto& ref : refs) {
                const uint side = sideOf(ref.lo, ref.hi, binPlane(r, b), 1u);
                isLeft += side & kLeft;
                isRight += (side & kRight) >> 1;
            }
            ASSERT_EQ(left, isLeft) << text(r, binPlane(r, b));
            ASSERT_EQ(right, isRight) << text(r, binPlane(r, b));
        }
    }
}

TEST(Build, chunksCoverTheReferencesOnce) {
    for (const uint count : {33u, kChunk - 1u, kChunk, kChunk + 1u, 5u * kChunk, 5u * kChunk + 7u}) {
        uint next = 100u;
        for (uint c = 0; c < chunksOf(count, 32u); c++) {
            const Chunk chunk = chunkOf(9u, 100u, count, c);
            EXPECT_EQ(chunk.node, 9u);
            EXPECT_EQ(chunk.first, next);
            EXPECT_GT(chunk.count, 0u);
            EXPECT_LE(chunk.count, kChunk);
            next += chunk.count;
        }
        EXPECT_EQ(next, 100u + count);
    }
}

TEST(Build, onlyLargeNodesHaveChunks) {
    for (const uint count : {0u, 1u, 32u}) EXPECT_EQ(chunksOf(count, 32u), 0u);
    EXPECT_EQ(chunksOf(33u, 32u), 1u);
}

TEST(Build, noLevelHasMoreChunksThanTheCapacity) {
    for (const uint below : {0u, 7u, 32u, 1023u, 1024u, 5000u}) {
        for (uint size : {below + 1u, below + 2u, kChunk, kChunk + 1u, 2u * kChunk + 1u}) {  // of every node
            if (!isLarge(size, below)) continue;
            for (uint nodes = 1; nodes < 40; nodes++)
                EXPECT_LE(nodes * chunksOf(size, below), chunkCapacity(nodes * size, below)) << size << " " << below;
        }
    }
}

TEST(Build, dispatchesCoverTheCount) {
    for (const uint row : {3u, kLongestRow})
        for (const uint groups : {0u, 1u, 65534u, 65535u, 65536u, 131070u, 131071u, 1u << 26}) {
            const DispatchSize d = dispatchSize(groups, row);
            EXPECT_LE(d.x, row);
            EXPECT_LE(d.y, row == kLongestRow ? 65535u : 1u << 26);
            EXPECT_EQ(d.z, 1u);
            const uint64_t covered = uint64_t{d.x} * d.y;
            EXPECT_GE(covered, groups);
            EXPECT_LT(covered, uint64_t{groups} + row) << "no idle row";
        }
    EXPECT_EQ(dispatchSize(0u, 65535u).x * dispatchSize(0u, 65535u).y, 0u) << "nothing to do: no workgroup";
}

// The thresholds are exact; the formula in double is right but for a rounding at n^13 = 2^(10 k - 5), which it meets,
// too.
TEST(Build, depthLimitIsTheFieldsFormula) {
    const auto formula = [](uint n) { return static_cast<uint>(std::lround(8.0 + 1.3 * std::log2(n))); };
    for (uint n = 1; n < 100'000; n++) ASSERT_EQ(depthLimit(0u, n), formula(n)) << n;
    for (uint k = 17; k < 30; k++)
        for (const uint n : {(1u << k) - 1, 1u << k, (1u << k) + 12345, 3u << (k - 1)})
            EXPECT_EQ(depthLimit(0u, n), formula(n)) << n;
    EXPECT_EQ(depthLimit(0u, 0u), 8u);
    EXPECT_EQ(depthLimit(5u, 1000u), 5u);
    EXPECT_EQ(depthLimit(99u, 1000u), kMaxDepth);
}

const Box kCell{vec3(0), vec3(16, 8, 4)};

float costAt(const std::vector<Interval>& refs, float plane, uint planarLeft) {
    uint left = 0, right = 0;
    for (const auto& r : refs) {
        const uint side = sideOf(r.lo, r.hi, plane, planarLeft);
        left += side & kLeft;
        right += (side & kRight) >> 1;
    }
    return splitCost(kDefaultCosts, kCell, 0u, plane, left, right);
}

// floor(log10 n), but 1 where that is 0; by hand at the thresholds.
TEST(Build, sampleStepIsTheLogarithm) {
    const std::pair<uint, uint> byHand[] = {{0, 1},        {1, 1},         {9, 1},          {10, 1},
                                            {99, 1},       {100, 2},       {999, 2},        {1000, 3},
                                            {9999, 3},     {10000, 4},     {99999, 4},      {100000, 5},
                                            {12700000, 7}, {999999999, 8}, {1000000000, 9}, {4294967295u, 9}};
    for (const auto& [n, step] : byHand) {
        EXPECT_EQ(sampleStep(n, true), step) << n;
        EXPECT_EQ(sampleStep(n, false), 1u) << n;
    }
}

TEST(Build, estimatesAreNeverEmptyNorTooMany) {
    EXPECT_EQ(estimatedCount(0u, 1u, 50u), 0u) << "without subsampling counts are true";
    EXPECT_EQ(estimatedCount(17u, 1u, 50u), 17u);
    EXPECT_EQ(estimatedCount(0u, 3u, 1000u), 1u);
    EXPECT_EQ(estimatedCount(100u, 3u, 1000u), 300u);
    EXPECT_EQ(estimatedCount(334u, 3u, 1000u), 1000u);
}

// On a grid of quarters all costs are exact but for the bonus. No plane between the two faces next to the first split
// is better than the snapped one, unless a face lies in the cell's own and so is no candidate.
TEST(Build, snappingNeverCostsMore) {
    int moved = 0, compared = 0;
    for (uint seed = 0; seed < 5000; seed++) {
        std::mt19937 random(seed);
        std::vector<Interval> refs;
        for (uint i = 0; i < 1u + seed % 9u; i++) {
            const float lo = static_cast<float>(random() % 16);
            refs.push_back({lo, min(16.0f, lo + static_cast<float>(random() % 6))});
        }
        const float plane = static_cast<float>(1 + random() % 63) / 4.0f;
        const Split first{costAt(refs, plane, 1u), 0u, plane, 1u};
        NearestFaces f = noFaces();
        for (const auto& r : refs) f = including(f, r.lo, r.hi, plane);
        const Split s = snapped(kDefaultCosts, first, kCell, f);
        ASSERT_LE(costAt(refs, s.position, s.planarLeft), s.cost) << "seed " << seed;
        ASSERT_LE(s.cost, first.cost) << "seed " << seed;
        moved += s.position != plane ? 1 : 0;
        const float below = f.below != 0u ? fromOrderedBits(f.below) : -1.0f;
        const float above = f.above != 0xFFFFFFFFu ? fromOrderedBits(f.above) : 17.0f;
        if (below == 0.0f || above == 16.0f) continue;
        for (float p = max(below, 0.0f) + 0.25f; p < min(above, 16.0f); p += 0.25f) {
            ASSERT_LE(s.cost, costAt(refs, p, 1u)) << "seed " << seed << " at " << p;
            compared++;
        }
    }
    EXPECT_GT(moved, 1000);
    EXPECT_GT(compared, 10000);
}

}  // namespace
}  // namespace cleave
