// The trace kernel with a stack: the same answers, and what it is for, fewer nodes visited.
#include <gtest/gtest.h>

#include "builders/builders.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"
#include "support/trace_cases.h"

namespace cleave::test {

TEST(TraceStack, EqualsBruteForceOverEveryTree) { expectAnswersOverTrees(Traversal::stack); }
TEST(TraceStack, HitsAtZeroWhatTheRayStartsIn) { expectHitsAtZero(Traversal::stack); }

TEST(TraceStack, HoldsAChildOfEveryDepth) {
    const DeepChain chain = deepChain();
    expectAnswers(chain.set, chain.tree, chain.rays, Traversal::stack);
}

// Both take the same way, but for cells that rounding lets the stack's ray see where it only passes by; the one without
// a stack walks parts of it again.
TEST(TraceStack, VisitsTheSameLeavesAndNoNodeTwice) {
    const TriangleSet set = mixedSet(2000, 3);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const std::vector<Ray> rays = mixedRays(2000, 5);
    Tracer& tracer = sharedTracer();
    const auto stack = tracer.trace(*tree, rays, {.traversal = Traversal::stack, .countSteps = true});
    const auto restart = tracer.trace(*tree, rays, {.countSteps = true});
    const uint64_t nodes = tree->header.nodeCount;
    uint64_t restarts = 0, again = 0, leaves = 0, more = 0;
    for (size_t i = 0; i < rays.size(); i++) {
        ASSERT_GE(stack.steps[i].leaves, restart.steps[i].leaves) << "ray " << i;
        ASSERT_LE(stack.steps[i].inner + stack.steps[i].leaves, nodes) << "ray " << i;
        leaves += restart.steps[i].leaves;
        more += stack.steps[i].leaves - restart.steps[i].leaves;
        ASSERT_EQ(stack.steps[i].restarts, 0u) << "ray " << i;
        restarts += restart.steps[i].restarts;
        again += restart.steps[i].inner - stack.steps[i].inner;
    }
    EXPECT_GT(restarts, 0u);
    EXPECT_GT(static_cast<int64_t>(again), 0);
    EXPECT_LE(more * 100, leaves);
}

}  // namespace cleave::test
