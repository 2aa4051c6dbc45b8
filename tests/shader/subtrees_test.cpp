#include <gtest/gtest.h>

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

}  // namespace cleave::test
