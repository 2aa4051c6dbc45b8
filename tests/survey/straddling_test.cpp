// Survey, section 5: a plane cuts O(sqrt n) of a node's n triangles on reasonable scenes, and that is what the build's
// O(N log N) rests on. (Memory and the two builds' sorting are judged in builders/exact_builders_test.cpp.)
#include "measure/straddling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "builders/builder_names.h"
#include "survey/survey_scenes.h"

namespace cleave {
namespace {

uint32_t crossing(const TriangleSet& set, uint32_t axisOfPlane, float plane) {
    const int axis = static_cast<int>(axisOfPlane);
    uint32_t count = 0;
    for (const uint32_t i : set.included) {
        const Triangle& t = set.triangles[i];
        count +=
            std::min({t.a[axis], t.b[axis], t.c[axis]}) < plane && std::max({t.a[axis], t.b[axis], t.c[axis]}) > plane;
    }
    return count;
}

// At the root nothing is clipped, so the corners of the triangles tell.
TEST(Straddling, OfTheRootAreTheTrianglesWithCornersOnBothSides) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        const TriangleSet set = makeTriangleSet(test::soup(seed, 500, 0.02f + 0.02f * static_cast<float>(seed)));
        for (const std::string_view builder : {"exact", "hunt-one", "spatial-median"}) {
            SCOPED_TRACE(testing::Message() << builder << " seed " << seed);
            const KdTree tree = cpuBuilder(builder).build(set, {}).tree;
            if (isLeaf(tree.nodes[0])) continue;
            const CutNode root = cutNodes(tree).back();
            EXPECT_EQ(root.triangles, 500u);
            EXPECT_EQ(root.straddling, crossing(set, nodeAxis(tree.nodes[0]), nodePosition(tree.nodes[0])));
        }
    }
}

TEST(Straddling, OfATreeByHand) {
    KdTree tree;
    tree.nodes = {innerNode(0, 0.5f, 1), innerNode(1, 0.5f, 3), leafNode(0, 3), leafNode(3, 2), leafNode(5, 2)};
    tree.leafTriangles = {9, 2, 4, 7, 2, 2, 1};  // right: 2 4 9; left: 2 7 and 1 2
    const std::vector<CutNode> nodes = cutNodes(tree);
    ASSERT_EQ(nodes.size(), 2u);
    EXPECT_EQ(nodes[0].triangles, 3u);
    EXPECT_EQ(nodes[0].straddling, 1u);
    EXPECT_EQ(nodes[1].triangles, 5u);
    EXPECT_EQ(nodes[1].straddling, 1u);
    EXPECT_EQ(fitStraddling(nodes).octaves, 0u);
}

TEST(Straddling, FitFindsThePowerThatWasPutIn) {
    for (const double power : {0.25, 0.5, 1.0}) {
        std::vector<CutNode> nodes;
        for (uint32_t n = 16; n <= 1u << 20; n *= 2)
            for (uint32_t i = 0; i < (1u << 20) / n; ++i)
                nodes.push_back({n, static_cast<uint32_t>(std::lround(40.0 * std::pow(n, power)))});
        const StraddlingLaw law = fitStraddling(nodes, 16);
        EXPECT_EQ(law.octaves, 17u);
        EXPECT_NEAR(law.exponent, power, 0.01);
        EXPECT_NEAR(law.factor, 40.0, 2.0);
    }
}

struct Measured {
    StraddlingLaw law;
    double worst = 0.0;  // straddling / sqrt(triangles), of any node
};

Measured measure(const char* scene, const std::vector<Triangle>& triangles, std::string_view builder) {
    const std::vector<CutNode> nodes = cutNodes(cpuBuilder(builder).build(makeTriangleSet(triangles), {}).tree);
    Measured m{fitStraddling(nodes)};
    for (const CutNode& node : nodes)
        m.worst = std::max(m.worst, node.straddling / std::sqrt(static_cast<double>(node.triangles)));
    std::printf("%-20s  %-14s  %.3f n^%.3f over %2u octaves, at most %5.2f sqrt(n)\n", scene,
                std::string(builder).c_str(), m.law.factor, m.law.exponent, m.law.octaves, m.worst);
    return m;
}

// A sheet's triangles are cut along a line: never more than c sqrt(n), with one c for all sizes. The exponent of exact
// SAH is a little above a half, since it looks for planes that cut little, and small nodes have more such planes.
TEST(Straddling, GrowsAsTheRootOnAGrid) {
    for (const uint32_t n : {50u, 100u, 200u}) {
        SCOPED_TRACE(n);
        const auto grid = test::turnedGrid(n);
        const Measured exact = measure("turned grid", grid, "exact");
        const Measured median = measure("turned grid", grid, "spatial-median");
        EXPECT_LE(exact.worst, 3.0);
        EXPECT_LE(median.worst, 3.0);
        if (n < 200) continue;  // too few octaves
        EXPECT_NEAR(exact.law.exponent, 0.5, 0.1);
        EXPECT_NEAR(median.law.exponent, 0.5, 0.07);
    }
}

// Small triangles that fill space are cut along a face of a cube, n^(2/3), and large ones are nearly all cut: where
// the claim does not hold, this says so.
TEST(Straddling, GrowsFasterWhereTrianglesFillSpace) {
    const Measured fine = measure("soup of small ones", test::soup(1, 40000, 0.01f), "spatial-median");
    EXPECT_NEAR(fine.law.exponent, 2.0 / 3.0, 0.05);
    const Measured coarse = measure("soup of large ones", test::soup(1, 4000, 0.5f), "exact");
    EXPECT_GT(coarse.law.exponent, 0.75);
    EXPECT_GT(coarse.worst, 10.0);
}

}  // namespace
}  // namespace cleave
