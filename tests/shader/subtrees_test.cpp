#include <gtest/gtest.h>

#include <random>

#include "shared/clip.h"
#include "support/build_pass.h"
#include "support/scenes.h"

namespace cleave::test {
namespace {

// Triangles that overlap much, so that planes cut many of them.
std::vector<Triangle> overlapping(uint32_t n, uint32_t seed) {
    std::vector<Triangle> triangles = mixedTriangles(n, seed);
    for (Triangle& t : triangles) {
        const vec3 centre = (t.a + t.b + t.c) / 3.0f;
        for (vec3* v : {&t.a, &t.b, &t.c}) *v = centre + (*v - centre) * 3.0f;
    }
    return triangles;
}

constexpr float kWall = 0.5f;

// A triangle across x = kWall, and just within an end in y of its part beyond that a plane outside which nothing is
// left of it: within the lower end, or the upper one. `plane` stays 0 if there is none.
struct Grazed {
    Triangle triangle;
    float plane = 0.0f;
};
Grazed grazed(bool upper) {
    std::mt19937 random(1);
    const auto between = [&random](float lo, float hi) {
        return std::uniform_real_distribution<float>(lo, hi)(random);
    };
    Grazed g;
    for (int tries = 0; tries < 100 && g.plane == 0.0f; tries++) {
        g.triangle = {{between(0.4f, 0.45f), between(0.05f, 0.1f), between(0.1f, 0.6f)},
                      {between(0.7f, 0.74f), between(0.4f, 0.5f), between(0.1f, 0.6f)},
                      {between(0.1f, 0.4f), between(0.4f, 0.5f), between(0.1f, 0.6f)}};
        if (upper)
            for (vec3* v : {&g.triangle.a, &g.triangle.b, &g.triangle.c}) v->y = 0.5f - v->y;
        const Box beyond = splitBoxes(g.triangle, triangleBox(g.triangle), 0, kWall).right;
        const float plane = nextFloat(upper ? beyond.hi.y : beyond.lo.y, !upper);
        const SplitBoxes parts = splitBoxes(g.triangle, beyond, 1, plane);
        if (isEmpty(upper ? parts.right : parts.left)) g.plane = plane;
    }
    return g;
}

bool holds(const BuildArrays& a, uint32_t node, uint32_t triangle) {
    const KdNode n = a.tree[node];
    if (!isLeaf(n)) return holds(a, nodeChild(n), triangle) || holds(a, nodeChild(n) + 1, triangle);
    const auto first = a.leafRefs.begin() + leafFirst(n);
    return std::find(first, first + leafCount(n), triangle) != first + leafCount(n);
}

}  // namespace

TEST(Subtrees, EqualsTwinAtEverySize) {
    uint32_t seed = 1;
    for (uint32_t n : kSizes) expectPassEqualsTwin("subtrees", n, seed++);
}

// What outgrows a workgroup is left to the other passes, by both.
TEST(Subtrees, LeavesWhatOutgrowsAWorkgroup) {
    BuildInfo info;
    info.costTraverse = 0.001f;  // so that almost every split pays
    info.capacity = {100'000, 100'000, 1'000'000, 1'000'000};
    BuildPair pair(overlapping(1000, 1), {}, info);
    uint32_t built = 0;
    uint32_t left = 0;
    const auto countBlocks = [&](uint32_t depth) {
        for (uint32_t n = 0; n < pair.arrays.state.level[depth].nodeCount; n++) {
            const BuildNode& node = pair.arrays.nodesIn(depth)[n];
            if (!isSubtree(node.count, info.exactUpTo)) continue;
            (node.split.axis == kSubtreeAxis ? built : left)++;
        }
    };
    for (const twin::Pass& pass : twin::setupPasses()) pass.run(pair.arrays, 0);
    const BuildState& state = pair.arrays.state;
    for (uint32_t depth = 0; depth < state.maxDepth && state.level[depth].nodeCount > 0; depth++)
        for (const twin::Pass& pass : twin::levelPasses()) {
            if (!pass.row.runs(pair.choice())) continue;
            if (pass.run != twin::subtrees) {
                pass.run(pair.arrays, depth);
                continue;
            }
            EXPECT_EQ(pair.differenceAfter(pass, depth, depth % 2 == 0), "") << "at depth " << depth;
            countBlocks(depth);
        }
    EXPECT_GT(built, 0u);
    EXPECT_GT(left, 0u);
}

// Triangle 0 is cut at the wall, and what is left of it by a plane that its box crosses but the triangle does not.
TEST(Subtrees, PutsEmptyPartsNowhere) {
    for (const bool upper : {false, true}) {
        SCOPED_TRACE(upper ? "upper end" : "lower end");
        const Grazed g = grazed(upper);
        ASSERT_GT(g.plane, 0.0f);
        std::vector<Triangle> world{g.triangle};
        for (int k = 0; k < 8; k++) {
            world.push_back({{0, 0, 0}, {kWall, 0.5f, 0}, {0, 0.5f, 0.75f}});
            world.push_back({{kWall, upper ? 0.5f : 0.0f, 0}, {0.75f, g.plane, 0}, {kWall, g.plane, 0.75f}});
        }
        BuildInfo info;
        info.emptyBonus = 1.0f;  // what is empty is not cut off first
        BuildPair pair(world, {}, info);
        const BuildArrays& a = pair.arrays;
        for (const twin::Pass& pass : twin::setupPasses()) pass.run(pair.arrays, 0);
        for (const twin::Pass& pass : twin::levelPasses())
            if (pass.run == twin::subtrees)
                EXPECT_EQ(pair.differenceAfter(pass, 0, false), "");
            else
                pass.run(pair.arrays, 0);
        ASSERT_FALSE(isLeaf(a.tree[0]));
        ASSERT_EQ(nodeAxis(a.tree[0]), 0u);
        ASSERT_EQ(nodePosition(a.tree[0]), kWall);
        const KdNode beyond = a.tree[nodeChild(a.tree[0]) + 1];
        ASSERT_FALSE(isLeaf(beyond));
        ASSERT_EQ(nodeAxis(beyond), 1u);
        ASSERT_EQ(nodePosition(beyond), g.plane);
        EXPECT_EQ(holds(a, nodeChild(beyond), 0), upper);
        EXPECT_EQ(holds(a, nodeChild(beyond) + 1, 0), !upper);
    }
}

}  // namespace cleave::test
