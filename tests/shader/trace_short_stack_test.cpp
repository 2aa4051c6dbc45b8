// The trace kernel with a short stack: the same answers, by a way between the other two.
#include <gtest/gtest.h>

#include "builders/builders.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"
#include "support/trace_cases.h"

namespace cleave::test {

TEST(TraceShortStack, EqualsBruteForceOverEveryTree) { expectAnswersOverTrees(Traversal::shortStack); }
TEST(TraceShortStack, HitsAtZeroWhatTheRayStartsIn) { expectHitsAtZero(Traversal::shortStack); }

// A child waits at every depth, far more than the stack holds.
TEST(TraceShortStack, FindsAgainWhatFellOut) {
    const DeepChain chain = deepChain();
    expectAnswers(chain.set, chain.tree, chain.rays, Traversal::shortStack);
}

// It visits the leaves that the stackless walk visits, and no more inner nodes.
TEST(TraceShortStack, VisitsTheSameLeavesWithFewerRestarts) {
    const TriangleSet set = mixedSet(2000, 3);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const std::vector<Ray> rays = mixedRays(2000, 5);
    Tracer& tracer = sharedTracer();
    const auto some = tracer.trace(*tree, rays, {.traversal = Traversal::shortStack, .countSteps = true});
    const auto none = tracer.trace(*tree, rays, {.countSteps = true});
    uint64_t someRestarts = 0, restarts = 0;
    for (size_t i = 0; i < rays.size(); i++) {
        ASSERT_EQ(some.steps[i].leaves, none.steps[i].leaves) << "ray " << i;
        ASSERT_LE(some.steps[i].inner, none.steps[i].inner) << "ray " << i;
        someRestarts += some.steps[i].restarts;
        restarts += none.steps[i].restarts;
    }
    EXPECT_GT(someRestarts, 0u);  // else the stack is not short for these rays
    EXPECT_LT(4 * someRestarts, restarts);
}

}  // namespace cleave::test
