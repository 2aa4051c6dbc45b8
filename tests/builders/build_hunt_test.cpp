#include <gtest/gtest.h>

#include <cmath>

#include "builders/adaptive_samples.h"
#include "builders/builders.h"
#include "measure/statistics.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

struct Extents {
    std::vector<float> lo, hi;
    BoxExtents view() const { return {lo, hi}; }
};

// Boxes in [0, 1]: spread evenly, crowded at one end, all in one place, or on a coarse grid and often flat.
enum class Spread { even, crowded, clump, snapped };

Extents extents(Spread spread, uint32_t seed, size_t count) {
    test::Random random(seed);
    Extents e;
    for (size_t i = 0; i < count; ++i) {
        float lo = random.unit(), hi = random.unit();
        if (spread == Spread::even) hi = std::min(1.0f, lo + 0.1f * hi);
        if (spread == Spread::crowded) lo = std::pow(lo, 12.0f), hi = std::min(1.0f, lo * (1.0f + hi));
        if (spread == Spread::clump) lo = 0.6f + 1e-6f * lo, hi = lo + 1e-6f * hi;
        if (spread == Spread::snapped) lo = std::round(lo * 8.0f) / 8.0f, hi = std::round(hi * 8.0f) / 8.0f;
        e.lo.push_back(std::min(lo, hi));
        e.hi.push_back(std::max(lo, hi));
    }
    return e;
}

uint32_t beforeOf(const Extents& e, float x) {
    return static_cast<uint32_t>(std::count_if(e.lo.begin(), e.lo.end(), [x](float lo) { return lo < x; }));
}
uint32_t behindOf(const Extents& e, float x) {
    return static_cast<uint32_t>(std::count_if(e.hi.begin(), e.hi.end(), [x](float hi) { return hi > x; }));
}

TEST(CountSides, EqualsCountingOneByOne) {
    for (uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const Extents e = extents(seed % 2 == 0 ? Spread::snapped : Spread::even, seed, seed * 5);
        test::Random random(seed);
        std::vector<CostSample> samples;
        for (uint32_t i = 0; i < seed; ++i) samples.push_back({std::round(random.unit() * 16.0f) / 16.0f, 77, 77});
        countSides(e.view(), samples);
        for (const CostSample& s : samples) {
            EXPECT_EQ(s.left, beforeOf(e, s.position));
            EXPECT_EQ(s.right, behindOf(e, s.position));
        }
    }
}

class AdaptiveSamples : public testing::TestWithParam<uint32_t> {};

// The error bound of the paper: length times growth of left - right, between any two neighbours.
TEST_P(AdaptiveSamples, AreBoundedBetweenNeighbours) {
    const uint32_t q = GetParam();
    std::vector<CostSample> samples;
    for (const Spread spread : {Spread::even, Spread::crowded, Spread::clump, Spread::snapped})
        for (uint32_t seed = 0; seed < 8; ++seed) {
            SCOPED_TRACE(testing::Message() << "spread " << static_cast<int>(spread) << " seed " << seed);
            const size_t n = 37 + 300 * seed;
            Extents e = extents(spread, seed, n);
            e.lo[0] = 0.0f;  // boxes in the corners keep the range as it is
            e.hi[1] = 1.0f;
            takeAdaptiveSamples(e.view(), 0.0f, 1.0f, q, samples);
            ASSERT_EQ(samples.size(), 2 * q + 2);
            const double bound = 2.0 * static_cast<double>(n) / (q * q);
            for (size_t i = 1; i < samples.size(); ++i) {
                const CostSample &a = samples[i - 1], &b = samples[i];
                ASSERT_LE(a.position, b.position);
                const double growth = (double(b.left) - double(b.right)) - (double(a.left) - double(a.right));
                EXPECT_LE((double(b.position) - double(a.position)) * growth, bound);
            }
        }
}

TEST_P(AdaptiveSamples, HoldTrueCountsAndStayInRange) {
    std::vector<CostSample> samples;
    const Extents e = extents(Spread::crowded, 5, 500);
    const float from = *std::min_element(e.lo.begin(), e.lo.end()), to = *std::max_element(e.hi.begin(), e.hi.end());
    takeAdaptiveSamples(e.view(), from, to, GetParam(), samples);
    EXPECT_EQ(samples.front().position, from);
    EXPECT_EQ(samples.back().position, to);
    for (const CostSample& s : samples) {
        EXPECT_EQ(s.left, beforeOf(e, s.position));
        EXPECT_EQ(s.right, behindOf(e, s.position));
    }
}

INSTANTIATE_TEST_SUITE_P(Q, AdaptiveSamples, testing::Range(4u, 65u));

// The interpolated cost, in double, at a thousand places: none is below the valley, and the valley is one of them.
TEST(Valley, IsTheLowestPlaceOfTheInterpolatedCost) {
    int inside = 0;
    for (uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const Box cell{vec3(0), vec3(0.2f) + random.point(0.0f, 1.0f)};
        const int axis = static_cast<int>(seed % 3);
        const float from = 0.4f * cell.hi[axis] * random.unit(), to = cell.hi[axis] * random.between(0.5f, 1.0f);
        const CostSample a{from, random.below(100), 50 + random.below(200)};
        const CostSample b{to, a.left + random.below(200), a.right - random.below(50)};
        const Valley valley = valleyBetween(a, b, cell, seed % 3);

        const auto costAt = [&](double x) {
            const double y = cell.hi[(axis + 1) % 3], z = cell.hi[(axis + 2) % 3], p = (x - from) / (to - from);
            const double left = x * (y + z) + y * z, right = (cell.hi[axis] - x) * (y + z) + y * z;
            return left * (a.left + p * (double(b.left) - a.left)) +
                   right * (a.right + p * (double(b.right) - a.right));
        };
        EXPECT_NEAR(valley.cost, costAt(valley.position), 1e-4 * valley.cost);
        for (int i = 0; i <= 1000; ++i) EXPECT_GE(costAt(from + i * (double(to) - from) / 1000), 0.9999 * valley.cost);
        if (from < valley.position && valley.position < to) ++inside;
    }
    EXPECT_GT(inside, 50) << "the ends are no test of the parabola";
}

double costOf(const KdTree& tree) { return computeStatistics(tree).sahCost.value(); }

TEST(BuildHunt, SmallNodesAreSplitExactly) {
    for (uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        // Few and small: at most 36 references in the root and below.
        const auto triangles = seed % 2 == 0 ? test::integerSoup(seed, 1 + seed % 36, 3 + seed % 5)
                                             : test::soup(seed, 1 + seed % 36, 0.3f);
        const TriangleSet set = makeTriangleSet(triangles);
        EXPECT_EQ(treeHash(buildHuntAll(set, {})), treeHash(buildExact(set, {})));
        EXPECT_EQ(treeHash(buildHuntHybrid(set, {})), treeHash(buildExact(set, {})));
    }
}

// The project's bounds, on a surface and on loose triangles.
TEST(BuildHunt, CostsLittleMoreThanExact) {
    for (const TriangleSet& set :
         {makeTriangleSet(test::bumpySphere(60)), makeTriangleSet(test::soup(3, 5000, 0.02f))}) {
        const double exact = costOf(buildExact(set, {}));
        EXPECT_LE(costOf(buildHuntAll(set, {})), 1.05 * exact);
        EXPECT_LE(costOf(buildHuntHybrid(set, {})), 1.05 * exact);
        EXPECT_LE(costOf(buildHuntOne(set, {})), 1.15 * exact);
    }
}

TEST(BuildHunt, HybridLooksAtAllAxesOfSmallNodesOnly) {
    const TriangleSet few = makeTriangleSet(test::soup(1, 1024, 0.02f));
    EXPECT_EQ(treeHash(buildHuntHybrid(few, {})), treeHash(buildHuntAll(few, {})));
    EXPECT_NE(treeHash(buildHuntHybrid(few, {})), treeHash(buildHuntOne(few, {})));
    // A crowded wall and a sparse one: the cheapest cut is between them, the longest axis runs along them.
    std::vector<Triangle> walls;
    for (const Triangle& t : test::soup(2, 2000, 0.001f)) {
        const float x = walls.size() % 10 == 0 ? 0.9f : 0.0f;
        const auto onWall = [&](vec3 p) { return vec3(x + 0.001f * p.x, p.y, p.z * 1.2f); };
        walls.push_back({onWall(t.a), onWall(t.b), onWall(t.c)});
    }
    const TriangleSet set = makeTriangleSet(walls);
    EXPECT_EQ(nodeAxis(buildHuntAll(set, {}).nodes[0]), 0u);
    EXPECT_EQ(nodeAxis(buildHuntHybrid(set, {}).nodes[0]), 2u);
    EXPECT_EQ(nodeAxis(buildHuntOne(set, {}).nodes[0]), 2u);
}

// Of the root: whether its plane is a face of a box along its axis.
bool rootIsAtAFace(const KdTree& tree, const TriangleSet& set) {
    const int axis = static_cast<int>(nodeAxis(tree.nodes[0]));
    const float plane = nodePosition(tree.nodes[0]);
    return std::any_of(set.triangles.begin(), set.triangles.end(), [&](const Triangle& t) {
        const Box box = triangleBox(t);
        return box.lo[axis] == plane || box.hi[axis] == plane;
    });
}

using Build = KdTree (*)(const TriangleSet&, const BuildSettings&, BuildReport*);

TEST(BuildHunt, WithoutSnappingPlanesAreWhereTheInterpolationPutsThem) {
    BuildSettings pure;
    pure.snap = false;
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleSet set = makeTriangleSet(test::soup(seed, 300, 0.05f));
        for (const Build build : {buildHuntAll, buildHuntHybrid, buildHuntOne}) {
            EXPECT_TRUE(rootIsAtAFace(build(set, {}, nullptr), set));
            EXPECT_FALSE(rootIsAtAFace(build(set, pure, nullptr), set));
        }
    }
}

// Two clumps of cubes with nothing between: a plane anywhere in the gap costs the same, so that its first sample is
// taken. The cell, 0 to 16, has uniform samples 16 / 9 apart. Up to the first of these left - right grows by half of
// all that it grows, so that half of the eight adaptive ones come there, at fifths: at 3 / 5 of 16 / 9 the gap has
// begun.
TEST(BuildHunt, WithoutSnappingAGapIsCutAtASample) {
    std::vector<Triangle> clumps;
    for (uint32_t i = 0; i < 40; ++i)
        for (const float x : {0.0f, 15.0f}) clumps.push_back({{x, 0, 0}, {x + 1, 1, 0}, {x + 0.5f, 0.5f, 1}});
    const TriangleSet set = makeTriangleSet(clumps);
    ASSERT_EQ(set.exponent, 5);
    BuildSettings pure;
    pure.snap = false;
    EXPECT_EQ(nodePosition(buildHuntAll(set, {}).nodes[0]), 1.0f / 32.0f);
    EXPECT_NEAR(nodePosition(buildHuntAll(set, pure).nodes[0]), 16.0f / 15.0f / 32.0f, 1e-6f);
}

TEST(BuildHunt, WithoutOtherAxesTheLongestAloneDecides) {
    std::vector<Triangle> sheets;
    for (uint32_t i = 0; i < 50; ++i) {
        const float z = 0.01f * static_cast<float>(i);
        sheets.push_back({{0, 0, z}, {1, 0, z}, {1, 0.8f, z}});
    }
    const TriangleSet set = makeTriangleSet(sheets);
    BuildSettings pure;
    pure.otherAxes = false;
    EXPECT_EQ(buildHuntOne(set, pure).nodes.size(), 1u);
    EXPECT_EQ(treeHash(buildHuntAll(set, pure)), treeHash(buildHuntAll(set, {})));
}

// Sheets that fill the cell's longest side cannot be split along it: then the others are tried.
TEST(BuildHunt, OneAxisTurnsToOthersWhereTheLongestHasNoSplit) {
    std::vector<Triangle> sheets;
    for (uint32_t i = 0; i < 50; ++i) {
        const float z = 0.01f * static_cast<float>(i);
        sheets.push_back({{0, 0, z}, {1, 0, z}, {1, 0.8f, z}});
        sheets.push_back({{0, 0, z}, {1, 0.8f, z}, {0, 0.8f, z}});
    }
    const TriangleSet set = makeTriangleSet(sheets);
    EXPECT_EQ(nodeAxis(buildHuntOne(set, {}).nodes[0]), 2u);
}

}  // namespace
}  // namespace cleave
