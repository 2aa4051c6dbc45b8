// The O(N log N) build against the O(N log^2 N) one, which shares its sweep but not how events reach it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "builders/builders.h"
#include "builders/events.h"
#include "builders/graft.h"
#include "judge/validate.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

// A sheet of 2 n^2 triangles with gentle waves: no two rows at one height, as on a scanned surface.
std::vector<Triangle> wavySheet(uint32_t n) {
    const auto at = [&](uint32_t i, uint32_t j) {
        const float x = static_cast<float>(i) / static_cast<float>(n),
                    y = static_cast<float>(j) / static_cast<float>(n);
        return vec3(x + 0.1f * y * y, y - 0.1f * x * x, 0.2f * std::sin(3.0f * x) * std::cos(2.0f * y));
    };
    return test::sheetOf(n, at);
}

// Not only the same tree: the same nodes in the same places, and the same lists in the same order.
void expectIdentical(const KdTree& a, const KdTree& b) {
    EXPECT_EQ(treeHash(a), treeHash(b));
    EXPECT_EQ(a.exponent, b.exponent);
    EXPECT_EQ(a.leafTriangles, b.leafTriangles);
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (size_t i = 0; i < a.nodes.size(); ++i) {
        ASSERT_EQ(a.nodes[i].plane, b.nodes[i].plane) << i;
        ASSERT_EQ(a.nodes[i].link, b.nodes[i].link) << i;
    }
}

// Both exact builders, counting and sorting in small nodes, with one thread and several.
void expectSameFromAll(const std::vector<Triangle>& triangles, BuildSettings settings = {}) {
    const TriangleSet set = makeTriangleSet(triangles);
    settings.smallNodes = SmallNodes::sort;
    const KdTree expected = buildExactNLog2N(set, settings);
    EXPECT_TRUE(validate(expected, set, depthLimit(settings, set.included.size())).ok());
    for (const SmallNodes small : {SmallNodes::count, SmallNodes::sort}) {
        SCOPED_TRACE(small == SmallNodes::count ? "counting" : "sorting");
        settings.smallNodes = small;
        expectIdentical(buildExactNLog2N(set, settings), expected);
        for (const uint32_t threads : {1u, 2u, 3u}) {
            SCOPED_TRACE(threads);
            settings.threads = threads;
            expectIdentical(buildExact(set, settings), expected);
        }
    }
}

TEST(ExactBuilders, AgreeOnRandomSets) {
    for (uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        expectSameFromAll(test::soup(seed, 1 + random.below(600), random.between(0.005f, 0.5f)));
    }
}

TEST(ExactBuilders, AgreeOnSnappedSets) {
    for (uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        expectSameFromAll(test::integerSoup(seed, 1 + random.below(400), 2 + random.below(12)));
    }
}

TEST(ExactBuilders, AgreeOnDegenerateSets) {
    const Triangle one{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
    expectSameFromAll({});
    expectSameFromAll({one});
    expectSameFromAll(std::vector<Triangle>(500, one));
    std::vector<Triangle> sheets, fan;
    for (uint32_t i = 0; i < 400; ++i) {
        const auto z = static_cast<float>(i / 4);
        sheets.push_back({{0, 0, z}, {1, 0, z}, {0, 1, z}});
        const float angle = static_cast<float>(i) * 0.01f;
        fan.push_back({{0, 0, 0}, {std::cos(angle), std::sin(angle), 0}, {std::cos(angle + 0.01f), 1, 0.5f}});
    }
    expectSameFromAll(sheets);
    expectSameFromAll(fan);
    sheets.resize(4);
    expectSameFromAll(sheets);  // all in one plane: the root has no extent along z
}

TEST(ExactBuilders, AgreeUnderSettings) {
    BuildSettings settings;
    settings.maxDepth = 5;
    expectSameFromAll(test::soup(7, 3000, 0.1f), settings);
    settings = {};
    settings.clip = false;
    expectSameFromAll(test::soup(8, 3000, 0.1f), settings);
}

// Large enough for every kind of sharing between threads; several runs, since a race shows in some only.
TEST(ExactBuilders, AgreeOnALargeSheet) {
    const TriangleSet set = makeTriangleSet(wavySheet(150));
    const KdTree expected = buildExactNLog2N(set, {});
    EXPECT_TRUE(validate(expected, set, depthLimit(BuildSettings{}, set.included.size())).ok());
    for (int run = 0; run < 4; ++run)
        for (const uint32_t threads : {1u, 2u, 3u}) {
            BuildSettings settings;
            settings.threads = threads;
            BuildReport report;
            expectIdentical(buildExact(set, settings, &report), expected);
            EXPECT_LE(report.peakBytes, 25 * 36 * set.included.size());
            EXPECT_GE(report.peakBytes, (sizeof(Event) * 6 + 28) * set.included.size()) << "the root's own";
        }
}

TEST(Events, EndBeforePlanarBeforeStartThenByReference) {
    std::vector<Event> events{makeEvent(0.5f, EventKind::start, 0),  makeEvent(0.5f, EventKind::planar, 9),
                              makeEvent(0.5f, EventKind::end, 7),    makeEvent(0.5f, EventKind::end, 3),
                              makeEvent(-1.0f, EventKind::start, 8), makeEvent(2.0f, EventKind::end, 1)};
    std::vector<Event> scratch(events.size());
    sortEvents(events, scratch.data());
    std::vector<uint32_t> refs;
    for (const Event e : events) refs.push_back(eventRef(e));
    EXPECT_EQ(refs, (std::vector<uint32_t>{8, 3, 7, 9, 0, 1}));
}

// Many events are sorted by digits, few by comparison: one order.
TEST(Events, CountingSortIsTheSameOrder) {
    test::Random random(5);
    std::vector<Event> events(20000), scratch(events.size());
    Event* end = events.data();
    for (uint32_t i = 0; i < 10000; ++i) {
        const auto lo = static_cast<float>(random.below(300)) - 150.0f;
        const Box box{vec3(lo), vec3(lo + static_cast<float>(random.below(3)))};
        end = writeEvents(end, box, 0, i);
    }
    events.resize(static_cast<size_t>(end - events.data()));
    std::vector<Event> expected = events;
    std::sort(expected.begin(), expected.end());
    sortEvents(events, scratch.data());
    EXPECT_EQ(events, expected);
}

// Counts by brute force over all boxes, at every face: what both builders share is right, too.
TEST(Events, SweepFindsTheBestOfAllFaces) {
    for (uint32_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        std::vector<Box> boxes(1 + random.below(30));
        for (Box& box : boxes)
            for (int axis = 0; axis < 3; ++axis) {
                box.lo[axis] = static_cast<float>(random.below(8));
                box.hi[axis] = box.lo[axis] + static_cast<float>(random.below(3));
            }
        const Box cell{vec3(0), vec3(9, 10, 11)};
        const auto count = static_cast<uint32_t>(boxes.size());
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const int a = static_cast<int>(axis);
            std::vector<Event> events(2 * boxes.size()), scratch(2 * boxes.size());
            Event* end = events.data();
            for (uint32_t i = 0; i < count; ++i) end = writeEvents(end, boxes[i], a, i);
            const std::span<Event> filled(events.data(), end);
            sortEvents(filled, scratch.data());
            Split expected = noSplit();
            for (float position = 0; position < 11; position += 1) {
                uint32_t left = 0, right = 0, planar = 0, faces = 0;
                for (const Box& box : boxes) {
                    const bool lies = box.lo[a] == position && box.hi[a] == position;
                    planar += lies;
                    left += box.lo[a] < position;
                    right += box.hi[a] > position;
                    faces += box.lo[a] == position || box.hi[a] == position;
                }
                if (faces > 0)
                    expected = betterOfBothSides(expected, kDefaultCosts, cell, axis, position, left, right, planar);
            }
            const Split found = sweepEvents(noSplit(), kDefaultCosts, filled, cell, axis, count);
            EXPECT_EQ(found.cost, expected.cost);
            EXPECT_EQ(found.axis, expected.axis);
            EXPECT_EQ(found.position, expected.position);
            EXPECT_EQ(found.planarLeft, expected.planarLeft);
        }
    }
}

// The events of a node and of all below it, from the finished tree alone: without clipping, a reference of a node ends
// in one of its leaves, and no box is flat, so that each triangle under a node has been six events there.
uint64_t eventsUnder(const KdTree& tree, uint32_t node, std::set<uint32_t>& triangles) {
    uint64_t events = 0;
    if (isLeaf(tree.nodes[node])) {
        const auto first = tree.leafTriangles.begin() + leafFirst(tree.nodes[node]);
        triangles.insert(first, first + leafCount(tree.nodes[node]));
    } else {
        for (uint32_t side = 0; side < 2; ++side) {
            std::set<uint32_t> below;
            events += eventsUnder(tree, nodeChild(tree.nodes[node]) + side, below);
            triangles.merge(below);
        }
    }
    return events + 6 * triangles.size();
}

uint64_t eventsOf(const KdTree& tree) {
    std::set<uint32_t> triangles;
    return eventsUnder(tree, 0, triangles);
}

TEST(ExactBuilders, SweepTheEventsOfEveryNode) {
    for (const uint32_t seed : {3u, 4u, 5u}) {
        SCOPED_TRACE(seed);
        const TriangleSet set = makeTriangleSet(test::soup(seed, 400, 0.2f));
        BuildSettings settings;
        settings.clip = false;
        settings.maxDepth = 60;  // no node is left alone for its depth
        for (const uint32_t threads : {1u, 2u})
            for (const SmallNodes small : {SmallNodes::count, SmallNodes::sort}) {
                settings.threads = threads;
                settings.smallNodes = small;
                BuildReport once, perNode;
                const KdTree tree = buildExact(set, settings, &once);
                EXPECT_EQ(once.eventsSwept, eventsOf(tree));
                const KdTree sorted = buildExactNLog2N(set, settings, &perNode);
                EXPECT_EQ(perNode.eventsSwept, eventsOf(sorted));
                EXPECT_GT(tree.nodes.size(), 200u);
            }
    }
}

// What is counted is swept without a sort; a root of 64 references is counted in whole.
TEST(ExactBuilders, SortSmallNodesWhereAsked) {
    const TriangleSet set = makeTriangleSet(test::soup(3, 64, 0.2f));
    BuildSettings settings;
    settings.threads = 1;
    BuildReport once[2], perNode[2];
    for (const SmallNodes small : {SmallNodes::count, SmallNodes::sort}) {
        settings.smallNodes = small;
        const size_t i = small == SmallNodes::count ? 0 : 1;
        buildExact(set, settings, &once[i]);
        buildExactNLog2N(set, settings, &perNode[i]);
    }
    EXPECT_EQ(perNode[0].sortSteps, 0u);
    EXPECT_EQ(once[0].sortSteps, 3 * sortSteps(128)) << "the root's events, which are sorted in any case";
    EXPECT_GT(once[1].sortSteps, once[0].sortSteps) << "and those of parts";
    EXPECT_GT(perNode[1].sortSteps, once[1].sortSteps);
}

// What the builds of a sheet of 2 n^2 triangles took, per triangle.
struct Work {
    double swept, sortedOnce, sortedPerNode, bytes, straddling;
};

Work workOf(uint32_t n) {
    const TriangleSet set = makeTriangleSet(wavySheet(n));
    BuildSettings settings;
    settings.threads = 1;
    settings.smallNodes = SmallNodes::sort;
    BuildReport once, perNode;
    const KdTree tree = buildExact(set, settings, &once);
    buildExactNLog2N(set, settings, &perNode);
    const int axis = static_cast<int>(nodeAxis(tree.nodes[0]));
    const float plane = nodePosition(tree.nodes[0]);
    double straddling = 0;
    for (const Triangle& t : set.triangles)
        if (std::min({t.a[axis], t.b[axis], t.c[axis]}) < plane && std::max({t.a[axis], t.b[axis], t.c[axis]}) > plane)
            straddling += 1;
    const auto count = static_cast<double>(set.included.size());
    return {static_cast<double>(once.eventsSwept) / count, static_cast<double>(once.sortSteps) / count,
            static_cast<double>(perNode.sortSteps) / count, static_cast<double>(once.peakBytes) / count,
            straddling / count};
}

// Survey, section 5, on sheets that grow by four: two levels more at the top, nothing new below. What is linear adds
// nothing per triangle, N log N adds the same each time, N log^2 N adds more each time.
TEST(ExactBuilders, WorkGrowsAsTheSurveySays) {
    const Work w[4] = {workOf(16), workOf(32), workOf(64), workOf(128)};
    const auto power = [&](double Work::*what) { return 1.0 + std::log(w[3].*what / (w[1].*what)) / std::log(16.0); };
    // From the second on: the first is hardly larger than the nodes that are scanned without events.
    EXPECT_NEAR(power(&Work::bytes), 1.0, 0.05) << "memory O(N)";
    EXPECT_NEAR(power(&Work::straddling), 0.5, 0.05) << "triangles across a plane O(sqrt N)";
    for (int i = 0; i + 1 < 4; ++i) {
        SCOPED_TRACE(i);
        const double swept = w[i + 1].swept - w[i].swept;
        EXPECT_NEAR(swept, 21.0, 4.0)
            << "two levels more, of six events per triangle, and the parts of straddling ones";
        const double perNode = w[i + 1].sortedPerNode - w[i].sortedPerNode;
        EXPECT_GT(perNode, 10.0 * swept) << "each of them sorted again";
        EXPECT_LT(w[i + 1].sortedOnce - w[i].sortedOnce, 2.0 * swept) << "sorted once";
        if (i > 0) {
            EXPECT_GT(perNode, 1.05 * (w[i].sortedPerNode - w[i - 1].sortedPerNode)) << "in longer sorts each time";
        }
    }
}

}  // namespace
}  // namespace cleave
