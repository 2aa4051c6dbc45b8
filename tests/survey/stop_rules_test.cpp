// Survey, section 4: whether a node is split, and where. By equation 4.1 it is if LSA L + RSA R - SA n is below zero at
// the best plane (footnote 2); by equation 4.2, with the costs of leaves, if C_i SA + C_l (LSA + RSA) + C_o (LSA L +
// RSA R) is below C_l SA + C_o SA n. Judged in integers, at the root of every builder that looks at all planes of few
// boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "builders/builder_names.h"
#include "survey/box_scene.h"
#include "twin/twin_builder.h"

namespace cleave {
namespace {

constexpr uint32_t kSeeds = 600;
constexpr uint32_t kMostBoxes = 30;  // no more than bins

// Triangles whose boxes have integer coordinates of at most 12, some flat: every cost is an exact integer, in float as
// well, but for the power of two that the scene is scaled by.
std::vector<Triangle> integerBoxes(uint32_t seed) {
    test::Random random(seed);
    std::vector<Triangle> triangles(1 + random.below(seed % 2 == 0 ? 6 : kMostBoxes));
    const uint32_t side = 2 + random.below(11), size = 1 + random.below(side);
    for (Triangle& t : triangles) {
        vec3 lo, hi;
        const uint32_t flat = random.below(9);  // an axis, or none
        for (int axis = 0; axis < 3; ++axis) {
            const uint32_t from = random.below(side), extent = static_cast<uint32_t>(axis) == flat ? 0 : 1;
            lo[axis] = static_cast<float>(from);
            hi[axis] =
                std::min(static_cast<float>(side), lo[axis] + static_cast<float>(extent * (1 + random.below(size))));
        }
        t = {lo, {hi.x, hi.y, lo.z}, {lo.x, hi.y, hi.z}};
        if (flat == 1) t.c = {lo.x, lo.y, hi.z};  // the others would lie on a line
    }
    return triangles;
}

struct Costs {
    int64_t inner, leaf, object;
};

int64_t halfAreaOf(const int64_t (&e)[3]) { return e[0] * e[1] + e[1] * e[2] + e[2] * e[0]; }

// The root's box, and boxes of the triangles.
struct Root {
    Box cell = emptyBox();
    std::vector<Box> boxes;

    explicit Root(const std::vector<Triangle>& triangles) {
        for (const Triangle& t : triangles) {
            boxes.push_back(triangleBox(t));
            cell = {glm::min(cell.lo, boxes.back().lo), glm::max(cell.hi, boxes.back().hi)};
        }
    }
    int64_t extent(int axis) const { return static_cast<int64_t>(cell.hi[axis] - cell.lo[axis]); }
    int64_t area() const { return halfAreaOf({extent(0), extent(1), extent(2)}); }
    int64_t leafCost(const Costs& costs) const {
        return area() * (costs.leaf + costs.object * static_cast<int64_t>(boxes.size()));
    }

    // Of a plane, planar boxes on the side where that is cheaper.
    int64_t splitCost(const Costs& costs, int axis, float plane) const {
        int64_t left[3] = {extent(0), extent(1), extent(2)}, right[3] = {extent(0), extent(1), extent(2)};
        left[axis] = static_cast<int64_t>(plane - cell.lo[axis]);
        right[axis] = static_cast<int64_t>(cell.hi[axis] - plane);
        int64_t l = 0, r = 0, planar = 0;
        for (const Box& box : boxes) {
            l += box.lo[axis] < plane ? 1 : 0;
            r += box.hi[axis] > plane ? 1 : 0;
            planar += box.lo[axis] == plane && box.hi[axis] == plane ? 1 : 0;
        }
        const int64_t areaL = halfAreaOf(left), areaR = halfAreaOf(right);
        const int64_t counted = std::min(areaL * (l + planar) + areaR * r, areaL * l + areaR * (r + planar));
        return costs.inner * area() + costs.leaf * (areaL + areaR) + costs.object * counted;
    }

    int64_t bestSplitCost(const Costs& costs) const {
        int64_t best = std::numeric_limits<int64_t>::max();
        for (int axis = 0; axis < 3; ++axis)
            for (const Box& box : boxes)
                for (const float plane : {box.lo[axis], box.hi[axis]})
                    if (cell.lo[axis] < plane && plane < cell.hi[axis])
                        best = std::min(best, splitCost(costs, axis, plane));
        return best;
    }
};

// What the stop says of the same costs.
Costs asStopped(const Costs& costs, StopRule stop) { return stop == StopRule::equation41 ? Costs{0, 0, 1} : costs; }

KdTree treeOf(std::string_view builder, const TriangleSet& set, const BuildSettings& settings) {
    return builder == "twin" ? buildTwin(set, settings).tree : cpuBuilder(builder).build(set, settings).tree;
}

TEST(StopRules, RootsAreSplitIffTheEquationsSaySo) {
    uint32_t split = 0, differ = 0;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const std::vector<Triangle> triangles = integerBoxes(seed);
        const Root root(triangles);
        const TriangleSet set = makeTriangleSet(triangles);
        ASSERT_EQ(set.included.size(), triangles.size());
        const Costs costs{seed % 4 * 15, seed % 3 * 7, 20};
        bool first = false;
        for (const StopRule stop : {StopRule::cost, StopRule::equation41}) {
            BuildSettings settings;
            settings.costs = {static_cast<float>(costs.inner), 20.0f, static_cast<float>(costs.leaf), 1.0f};
            settings.stop = stop;
            settings.smallNodes = seed % 2 == 0 ? SmallNodes::count : SmallNodes::sort;
            const Costs judged = asStopped(costs, stop);
            const int64_t best = root.bestSplitCost(judged);
            const bool pays = best < root.leafCost(judged);
            split += pays ? 1 : 0;
            differ += stop == StopRule::equation41 && pays != first ? 1 : 0;
            first = pays;
            for (const char* builder : {"exact", "exact-nlog2n", "hunt-all", "hunt-hybrid", "shevtsov", "twin"}) {
                SCOPED_TRACE(testing::Message() << builder << ", seed " << seed << ", stop " << static_cast<int>(stop));
                const KdNode node = treeOf(builder, set, settings).nodes[0];
                ASSERT_EQ(!isLeaf(node), pays);
                if (!pays) continue;
                const float plane = std::ldexp(nodePosition(node), set.exponent);
                EXPECT_EQ(root.splitCost(judged, static_cast<int>(nodeAxis(node)), plane), best);
            }
        }
    }
    std::printf("%u scenes: %u of %u roots are split, the two stops differ on %u\n", kSeeds, split, 2 * kSeeds, differ);
    EXPECT_GT(differ, kSeeds / 20);
}

}  // namespace
}  // namespace cleave
