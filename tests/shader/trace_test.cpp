// The trace kernel against the plainest walk and against brute force: hits are compared with ==.
#include <gtest/gtest.h>

#include <cstring>

#include "builders/builders.h"
#include "judge/oracle.h"
#include "run/tracer.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"
#include "support/trace_cases.h"
#include "twin/twin_builder.h"

namespace cleave::test {

TEST(Trace, EqualsBruteForceOverEveryTree) {
    for (uint32_t n : {0u, 1u, 2u, 33u, 500u}) {
        for (uint32_t seed = 1; seed <= 3; seed++) {
            SCOPED_TRACE("triangles " + std::to_string(n) + ", seed " + std::to_string(seed));
            const TriangleSet set = mixedSet(n, seed);
            const std::vector<Ray> rays = mixedRays(2000, seed);
            expectAnswers(set, buildTwin(set, BuildSettings{}).tree, rays, Traversal::restart);
            expectAnswers(set, buildExact(set, BuildSettings{}), rays, Traversal::restart);
            expectAnswers(set, buildBrute(set), rays, Traversal::restart);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(Trace, TakesAnyNumberOfRays) {
    const TriangleSet set = mixedSet(100, 7);
    const KdTree tree = buildExact(set, BuildSettings{});
    for (uint32_t n : kSizes) {
        SCOPED_TRACE("rays " + std::to_string(n));
        Tracer& tracer = sharedTracer();
        const std::vector<Ray> rays = mixedRays(n, n);
        const auto onDevice = uploadTree(device(), set, tree);
        const Tracer::Result result = tracer.trace(*onDevice, rays);
        ASSERT_EQ(result.hits.size(), n);
        for (size_t i = 0; i < n; i += 1 + n / 1000) {
            const Hit want = bruteForce(set, rays[i], Query::closest);
            ASSERT_EQ(std::memcmp(&want, &result.hits[i], sizeof(Hit)), 0) << "ray " << i;
        }
    }
}

// Of hits at the same t the lowest number wins, in whichever order leaves and their lists come.
TEST(Trace, GivesTiesToTheLowestNumber) {
    const Triangle one{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>(3, one));
    KdTree tree;
    tree.bounds = set.bounds;
    tree.exponent = set.exponent;
    tree.nodes = {leafNode(0, 3)};
    tree.leafTriangles = {2, 0, 1};
    expectAnswers(set, tree, {{{0.2f, 0.2f, 1.0f}, 0.0f, {0, 0, -1}, infinity()}}, Traversal::restart);
}

TEST(Trace, HitsAtZeroWhatTheRayStartsIn) { expectHitsAtZero(Traversal::restart); }

TEST(Trace, ReachesTheDeepestLeaf) {
    // Both words of the trail are used.
    const DeepChain chain = deepChain();
    expectAnswers(chain.set, chain.tree, chain.rays, Traversal::restart);
}

}  // namespace cleave::test
