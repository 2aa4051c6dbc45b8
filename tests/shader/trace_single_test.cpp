#include <gtest/gtest.h>

#include "builders/builders.h"
#include "support/device.h"
#include "support/scenes.h"
#include "support/trace_cases.h"

namespace cleave::test {
namespace {

// Steps are uncounted there and counted by a kernel that walks; both must answer as brute force does.
void expectAnswersOf(const std::vector<Triangle>& world, uint32_t seed) {
    const TriangleSet set = makeTriangleSet(world);
    const KdTree leaf = buildBrute(set);
    ASSERT_TRUE(uploadTree(device(), set, leaf)->isSingle());
    expectAnswers(set, leaf, mixedRays(2000, seed), Traversal::stack);
}

TEST(TraceSingle, AnswersAreThoseOfBruteForce) {
    constexpr uint32_t kSeed = 41;
    for (const uint32_t count : {0u, 1u, 2u, 7u, kFewInLeaf}) {
        SCOPED_TRACE(count);
        expectAnswersOf(mixedTriangles(count, kSeed + count), kSeed);
    }
}

TEST(TraceSingle, TiesGoToTheLowestNumber) {
    std::vector<Triangle> world = mixedTriangles(8, 42);
    world.insert(world.end(), world.begin(), world.begin() + 8);
    world.insert(world.end(), world.rbegin(), world.rbegin() + 8);
    expectAnswersOf(world, 42);
}

TEST(TraceSingle, SomeTrianglesStayOut) {
    std::vector<Triangle> world = mixedTriangles(12, 43);
    world[0].a.x = NAN;
    world[5].c = world[5].a;
    expectAnswersOf(world, 43);
}

TEST(TraceSingle, LargerLeavesAreWalked) {
    const TriangleSet set = mixedSet(kFewInLeaf + 20, 44);
    EXPECT_FALSE(uploadTree(device(), set, buildBrute(set))->isSingle());
}

}  // namespace
}  // namespace cleave::test
