#include <gtest/gtest.h>

#include "builders/builders.h"
#include "builders/decomposition.h"
#include "builders/threads.h"
#include "judge/oracle.h"
#include "judge/validate.h"
#include "measure/statistics.h"
#include "shared/build.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

BuildSettings withThreads(uint32_t threads) {
    BuildSettings settings;
    settings.threads = threads;
    return settings;
}

double costOf(const KdTree& tree) { return computeStatistics(tree).sahCost.value(); }

void expectValid(const KdTree& tree, const TriangleSet& set) {
    const ValidationReport report = validate(tree, set, depthLimit(BuildSettings{}, set.included.size()));
    EXPECT_TRUE(report.ok()) << report.errors.front();
}

// 200 k triangles are enough for five threads (2560 bins) to cut, and cut again.
class BuildShevtsov : public testing::TestWithParam<uint32_t> {};

TEST_P(BuildShevtsov, GivesTheSameValidTreeInEveryRun) {
    const TriangleSet set = makeTriangleSet(test::bumpySphere(80));
    const BuildSettings settings = withThreads(GetParam());
    const KdTree first = buildShevtsov(set, settings);
    expectValid(first, set);
    for (int run = 0; run < 4; ++run) EXPECT_EQ(treeHash(buildShevtsov(set, settings)), treeHash(first));
}

TEST_P(BuildShevtsov, AnswersAsBruteForceDoes) {
    for (const auto& triangles : {test::bumpySphere(30), test::soup(5, 6000, 0.03f), test::integerSoup(6, 3000, 12)}) {
        const TriangleSet set = makeTriangleSet(triangles);
        const KdTree tree = buildShevtsov(set, withThreads(GetParam()));
        expectValid(tree, set);
        for (const Ray& ray : test::raysAt(9, 200, -1.0f, 1.0f)) {
            const Hit expected = bruteForce(set, ray, Query::closest), hit = stackWalk(tree, set, ray, Query::closest);
            EXPECT_TRUE(hit.t == expected.t && hit.prim == expected.prim);
        }
    }
}

// Survey: exact SAH where there are as few references as bins. No such scene is cut for threads.
TEST_P(BuildShevtsov, IsExactUpToAsManyReferencesAsBins) {
    for (uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const auto triangles = seed % 2 == 0 ? test::integerSoup(seed, 1 + seed % 32, 3 + seed % 5)
                                             : test::soup(seed, 1 + seed % 32, 0.3f);
        const TriangleSet set = makeTriangleSet(triangles);
        EXPECT_EQ(treeHash(buildShevtsov(set, withThreads(GetParam()))), treeHash(buildExact(set, {})));
    }
}

TEST_P(BuildShevtsov, CostsLittleMoreThanExact) {
    for (const auto& triangles : {test::bumpySphere(60), test::soup(3, 8000, 0.02f)}) {
        const TriangleSet set = makeTriangleSet(triangles);
        EXPECT_LE(costOf(buildShevtsov(set, withThreads(GetParam()))), 1.10 * costOf(buildExact(set, {})));
    }
}

// Few bins cost something, many cost time and no more than that.
TEST_P(BuildShevtsov, TakesAnyNumberOfBins) {
    for (const auto& triangles : {test::bumpySphere(60), test::soup(3, 8000, 0.02f)}) {
        const TriangleSet set = makeTriangleSet(triangles);
        const double exact = costOf(buildExact(set, {}));
        for (const uint32_t bins : {2u, 33u, 64u, 65u, 100u, kMostBins}) {
            SCOPED_TRACE(bins);
            BuildSettings settings = withThreads(GetParam());
            settings.bins = bins;
            const KdTree tree = buildShevtsov(set, settings);
            expectValid(tree, set);
            EXPECT_LE(costOf(tree), (bins < 32 ? 1.5 : 1.1) * exact);
        }
    }
}

// Every part straddles every plane, or all lie in one: nothing to share out, and no harm done.
TEST_P(BuildShevtsov, SurvivesWhatCannotBeSharedOut) {
    std::vector<Triangle> sheet;
    for (const Triangle& t : test::soup(4, 6000, 0.01f))
        sheet.push_back({{t.a.x, t.a.y, 0}, {t.b.x, t.b.y, 0}, {t.c.x, t.c.y, 0}});
    const Triangle one{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
    for (const auto& triangles :
         {std::vector<Triangle>{}, std::vector<Triangle>{one}, std::vector<Triangle>(6000, one), sheet}) {
        const TriangleSet set = makeTriangleSet(triangles);
        expectValid(buildShevtsov(set, withThreads(GetParam())), set);
    }
}

INSTANTIATE_TEST_SUITE_P(Threads, BuildShevtsov, testing::Values(1u, 2u, 3u, 4u, 5u));

TEST(BuildShevtsov, SubsamplingChangesLittle) {
    const TriangleSet set = makeTriangleSet(test::bumpySphere(60));
    BuildSettings settings = withThreads(1);
    const KdTree sampled = buildShevtsov(set, settings);
    settings.subsample = false;
    const KdTree full = buildShevtsov(set, settings);
    EXPECT_NE(treeHash(sampled), treeHash(full));
    EXPECT_NEAR(costOf(sampled), costOf(full), 0.05 * costOf(full));
}

// The root's bins span the scene. One thread: no cut for others comes before.
TEST(BuildShevtsov, WithoutSnappingPlanesAreBoundariesOfBins) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleSet set = makeTriangleSet(test::soup(seed, 2000, 0.02f));
        BuildSettings settings = withThreads(1);
        const auto isBoundary = [&](const KdTree& tree) {
            const int axis = static_cast<int>(nodeAxis(tree.nodes[0]));
            const double lo = set.bounds.lo[axis], width = (double{set.bounds.hi[axis]} - lo) / kBins;
            const double bins = (nodePosition(tree.nodes[0]) - lo) / width;
            return std::fabs(bins - std::round(bins)) < 1e-4;
        };
        EXPECT_FALSE(isBoundary(buildShevtsov(set, settings)));
        settings.snap = false;
        EXPECT_TRUE(isBoundary(buildShevtsov(set, settings)));
    }
}

TEST(BuildShevtsov, LooksAtEveryReferenceOfTheLogarithm) {
    const uint32_t expected[][2] = {{0, 1},        {9, 1},        {10, 1},      {99, 1},     {100, 2},
                                    {999, 2},      {1000, 3},     {99999, 4},   {100000, 5}, {9999999, 6},
                                    {10000000, 7}, {99999999, 7}, {1u << 31, 9}};
    for (const auto& [n, step] : expected) {
        EXPECT_EQ(sampleStep(n, true), step) << n;
        EXPECT_EQ(sampleStep(n, false), 1u) << n;
    }
}

// A row of small triangles along x, at x = i.
std::vector<Triangle> row(uint32_t count) {
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        triangles.push_back({{x, 0, 0}, {x + 0.25f, 1, 0}, {x, 0, 1}});
    }
    return triangles;
}

std::vector<Part> partsOf(const TriangleSet& set, uint32_t threads, KdTree& tree, ByteCount& bytes) {
    tree.nodes.resize(1);
    std::vector<Part> parts;
    cleave::withThreads(threads, [&] { parts = decompose(tree, set, withThreads(threads), bytes); });
    return parts;
}

// 16384 triangles in a row; bins are no wider than 16 of them, so a quantile is met to that.
TEST(Decomposition, GivesEachThreadItsShare) {
    const TriangleSet set = makeTriangleSet(row(16384));
    for (uint32_t threads = 1; threads <= 9; ++threads) {
        SCOPED_TRACE(threads);
        KdTree tree;
        ByteCount bytes;
        const std::vector<Part> parts = partsOf(set, threads, tree, bytes);
        ASSERT_EQ(parts.size(), threads);
        EXPECT_EQ(tree.nodes.size(), 2 * threads - 1);
        for (const Part& part : parts) {
            EXPECT_NEAR(static_cast<double>(part.count), 16384.0 / threads, 40.0);
            for (size_t i = 1; i < part.count; ++i) EXPECT_LT(part.refs[i - 1].prim, part.refs[i].prim);
        }
    }
}

TEST(Decomposition, LeavesAloneWhatHasFewerReferencesThanBins) {
    for (const uint32_t count : {1024u, 1025u}) {
        KdTree tree;
        ByteCount bytes;
        EXPECT_EQ(partsOf(makeTriangleSet(row(count)), 2, tree, bytes).size(), count == 1024 ? 1u : 2u);
    }
}

TEST(Decomposition, GivesUpWhereOneSideKeepsAll) {
    const Triangle one{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
    KdTree tree;
    ByteCount bytes;
    EXPECT_EQ(partsOf(makeTriangleSet(std::vector<Triangle>(4000, one)), 4, tree, bytes).size(), 1u);
    EXPECT_EQ(tree.nodes.size(), 1u);
}

}  // namespace
}  // namespace cleave
