// Survey, section 7: of the plane between bins b - 1 and b, start counters 0 to b - 1 add up to the primitives on its
// left and end counters b and up to those on its right. Judged by counting intervals one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "builders/binning.h"
#include "shared/build.h"
#include "support/small_scenes.h"
#include "twin/passes.h"

namespace cleave {
namespace {

struct Interval {
    float lo, hi;
};

enum class Family { random, integer, flat, tiny, huge, nearPlanes };
constexpr Family kFamilies[] = {Family::random, Family::integer, Family::flat,
                                Family::tiny,   Family::huge,    Family::nearPlanes};

float coordinate(Family family, test::Random& random, uint32_t bins) {
    switch (family) {
        case Family::integer:
            return static_cast<float>(random.below(65)) - 32.0f;
        case Family::tiny:  // a few hundred neighbouring floats: some ranges are too narrow for their bins
            return uintBitsToFloat(floatBitsToUint(0.7f) + random.below(400));
        case Family::huge:
            return random.between(-1.0f, 1.0f) * 0x1p126f;
        case Family::nearPlanes: {  // of bins that span 0 to 1, or a float beside one
            const float plane = static_cast<float>(random.below(bins + 1)) / static_cast<float>(bins);
            const uint32_t what = random.below(3);
            return what == 0 ? plane : std::clamp(nextFloat(plane, what == 1), 0.0f, 1.0f);
        }
        default:
            return random.between(-3.0f, 5.0f);
    }
}

std::vector<Interval> intervals(Family family, uint32_t seed, uint32_t bins) {
    test::Random random(seed);
    std::vector<Interval> all(1 + random.below(120));
    for (Interval& i : all) {
        const float a = coordinate(family, random, bins), b = coordinate(family, random, bins);
        const bool flat = random.below(family == Family::flat ? 2 : 6) == 0;
        i = {flat ? a : std::min(a, b), flat ? a : std::max(a, b)};
    }
    if (family == Family::nearPlanes) all.push_back({0.0f, 1.0f});
    return all;
}

// Counted by the definition: what lies flat in the plane is on its left.
void expectCounts(const std::vector<Interval>& all, const BinRange& range, const uint32_t* starts,
                  const uint32_t* ends) {
    for (uint32_t b = 1; b < range.count; ++b) {
        const float plane = binPlane(range, b);
        uint32_t left = 0, right = 0, isLeft = 0, isRight = 0;
        for (uint32_t k = 0; k < b; ++k) left += starts[k];
        for (uint32_t k = b; k < range.count; ++k) right += ends[k];
        for (const Interval& i : all) {
            isLeft += i.lo < plane || (i.lo == plane && i.hi == plane);
            isRight += i.hi > plane;
        }
        ASSERT_EQ(left, isLeft) << range.count << " bins, plane " << b;
        ASSERT_EQ(right, isRight) << range.count << " bins, plane " << b;
    }
}

TEST(BinCounters, EqualCountingIntervals) {
    for (const Family family : kFamilies) {
        uint32_t resolved = 0, ranges = 0;
        for (uint32_t bins = 2; bins <= 32; ++bins)
            for (uint32_t seed = 0; seed < 40; ++seed) {
                SCOPED_TRACE(testing::Message() << "family " << static_cast<int>(family) << " seed " << seed);
                const std::vector<Interval> all = intervals(family, seed * 32 + bins, bins);
                float lo = all[0].lo, hi = all[0].hi;
                for (const Interval& i : all) lo = std::min(lo, i.lo), hi = std::max(hi, i.hi);
                const BinRange range = binRange(lo, hi, bins, 1.0f / static_cast<float>(bins));
                uint32_t starts[kBins] = {}, ends[kBins] = {};
                for (const Interval& i : all) {
                    ++starts[startBin(range, i.lo, i.hi)];
                    ++ends[endBin(range, i.hi)];
                }
                ++ranges;
                if (!isResolved(range)) {  // no planes but the range's ends
                    ASSERT_EQ(starts[0], all.size());
                    ASSERT_EQ(ends[0], all.size());
                    continue;
                }
                ++resolved;
                expectCounts(all, range, starts, ends);
                if (HasFatalFailure()) return;
            }
        EXPECT_GT(resolved, ranges / 2) << "too few were looked at, family " << static_cast<int>(family);
    }
}

// The pass of the builds, over the boxes of triangles: `begin` gives the range, `bin` counts, chunk by chunk, every
// triangle or every l-th one.
void expectPassCounts(const TriangleSet& set, uint32_t bins, bool subsample) {
    BuildInfo info;
    info.bins = bins;
    info.subsample = subsample;
    BuildArrays arrays = makeArrays(set.triangles, {}, info);  // scaled already, so that the scale is 1
    for (const twin::Pass& pass : twin::setupPasses()) pass.run(arrays, 0);
    twin::bin(arrays, 0);
    const auto step = subsample ? static_cast<size_t>(std::log10(set.included.size())) : size_t{1};
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        std::vector<Interval> counted;
        for (size_t i = 0; i < set.included.size(); i += step) {
            const Triangle& t = set.triangles[set.included[i]];
            counted.push_back({std::min({t.a[a], t.b[a], t.c[a]}), std::max({t.a[a], t.b[a], t.c[a]})});
        }
        const BinRange range = twin::rangeOf(arrays, arrays.nodes0[0].chunk, axis);
        ASSERT_EQ(range.count, bins);
        ASSERT_EQ(range.lo, set.bounds.lo[a]);
        ASSERT_EQ(range.hi, set.bounds.hi[a]);
        const uint32_t* starts = &arrays.bins[2 * axis * kBins];
        expectCounts(counted, range, starts, starts + kBins);
    }
}

TEST(BinCounters, OfThePassEqualCountingTriangles) {
    for (uint32_t bins = 2; bins <= 32; ++bins)
        for (const bool subsample : {false, true}) {
            SCOPED_TRACE(testing::Message() << bins << " bins, subsampling " << subsample);
            const auto triangles =
                bins % 2 == 0 ? test::soup(bins, 2500, 0.2f) : test::integerSoup(bins, 2500, 2 + bins);
            expectPassCounts(makeTriangleSet(triangles), bins, subsample);
            if (HasFatalFailure()) return;
        }
}

// The same on three axes at once, as shevtsov's builder counts them: a family along each.
TEST(BinCounters, OfSeveralAxesAtOnceEqualCountingIntervals) {
    uint32_t resolved = 0;
    for (uint32_t bins = 2; bins <= 32; ++bins)
        for (uint32_t seed = 0; seed < 60; ++seed) {
            SCOPED_TRACE(testing::Message() << bins << " bins, seed " << seed);
            std::vector<Interval> along[3];
            for (uint32_t axis = 0; axis < 3; ++axis)
                along[axis] = intervals(kFamilies[(seed + axis * (1 + seed / 6)) % 6], 7 * seed + axis, bins);
            const size_t count = std::min({along[0].size(), along[1].size(), along[2].size()});
            std::vector<ClippedRef> refs(count);
            for (size_t i = 0; i < count; ++i)
                for (int axis = 0; axis < 3; ++axis) {
                    refs[i].box.lo[axis] = along[axis][i].lo;
                    refs[i].box.hi[axis] = along[axis][i].hi;
                }
            const uint32_t step = 1 + seed % 4;
            Bins counted;
            fillBins(counted, refs, boundsOf(refs), bins, step);
            for (uint32_t axis = 0; axis < 3; ++axis) {
                std::vector<Interval> sampled;
                for (size_t i = 0; i < count; i += step) sampled.push_back(along[axis][i]);
                if (!isResolved(counted.range[axis])) continue;
                ++resolved;
                expectCounts(sampled, counted.range[axis], counted.starts(axis), counted.ends(axis));
                if (HasFatalFailure()) return;
            }
        }
    EXPECT_GT(resolved, 31u * 60u) << "too few were looked at";
}

}  // namespace
}  // namespace cleave
