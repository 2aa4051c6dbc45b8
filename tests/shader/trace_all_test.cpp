// The kernel trace_all against its twin, hit by hit with ==, and against the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "builders/builders.h"
#include "judge/crossings.h"
#include "run/tracer.h"
#include "support/closed_surfaces.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"
#include "support/trace_cases.h"
#include "twin/twin_builder.h"

namespace cleave::test {
namespace {

bool areSame(const Hit& a, const Hit& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expectAll(const TriangleSet& set, const KdTree& tree, const std::vector<Ray>& rays, uint32_t hitsPerRay) {
    SCOPED_TRACE("hits per ray " + std::to_string(hitsPerRay));
    Tracer& tracer = sharedTracer();
    const auto onDevice = uploadTree(device(), set, tree);
    const Tracer::Result found = tracer.all(*onDevice, rays, hitsPerRay);
    ASSERT_EQ(found.hits.size(), rays.size() * hitsPerRay);
    uint64_t invalid = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        std::vector<Hit> wanted = bruteCrossings(set, rays[i]);
        wanted.resize(hitsPerRay, missedHit());
        for (uint32_t k = 0; k < hitsPerRay; ++k)
            ASSERT_TRUE(areSame(found.hits[i * hitsPerRay + k], wanted[k])) << "ray " << i << ", hit " << k;
        invalid += isValidRay(rays[i]) ? 0 : 1;
    }
    EXPECT_EQ(found.invalidRays, invalid);
}

TEST(TraceAll, EqualsBruteForceOverEveryTree) {
    for (uint32_t n : {0u, 1u, 2u, 33u, 500u}) {
        for (uint32_t seed = 1; seed <= 3; seed++) {
            SCOPED_TRACE("triangles " + std::to_string(n) + ", seed " + std::to_string(seed));
            const TriangleSet set = mixedSet(n, seed);
            const std::vector<Ray> rays = mixedRays(1000, seed);
            for (const uint32_t hitsPerRay : {1u, 3u, 8u, 21u}) {
                expectAll(set, buildTwin(set, BuildSettings{}).tree, rays, hitsPerRay);
                if (HasFatalFailure()) return;
            }
            expectAll(set, buildExact(set, BuildSettings{}), rays, 8);
            expectAll(set, buildBrute(set), rays, 8);
            if (HasFatalFailure()) return;
        }
    }
}

// Each triangle is in many leaves, and the walk goes on from hits at the same t.
TEST(TraceAll, FindsEachOfManyAtTheSamePlaceOnce) {
    std::vector<Triangle> stack;
    for (int i = 0; i < 60; ++i) stack.push_back({{-1, -1, 0.25f * static_cast<float>(i / 20)}, {1, -1, 0}, {0, 1, 0}});
    const std::vector<Triangle> more = soup(3, 300, 0.3f);
    stack.insert(stack.end(), more.begin(), more.end());
    const TriangleSet set = makeTriangleSet(stack);
    std::vector<Ray> rays = raysAt(5, 400, -0.5f, 0.5f);
    for (float t = 0.0f; t < 1.0f; t += 0.25f) rays.push_back({{0, 0, -1}, 1.0f, {0, 0, 1}, 1.0f + t});
    expectAll(set, buildExact(set, BuildSettings{}), rays, 100);
}

TEST(TraceAll, EqualsTheReferenceAtEdgesAndVertices) {
    uint64_t hits = 0;
    for (uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const bool slivers = seed % 2 == 0;
        const std::vector<Triangle> world = slivers ? sliverStar(seed, 3) : latticeBlob(seed, 3, 6);
        const TriangleSet set = makeTriangleSet(world);
        Random random(seed);
        std::vector<Ray> rays = integerRays(seed, slivers ? 0 : 300, 6);
        for (int i = 0; i < 300; ++i) rays.push_back(aimedAt(world, random, slivers ? 1.0f : 6.0f));
        Tracer& tracer = sharedTracer();
        const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
        constexpr uint32_t kMost = 32;
        const Tracer::Result found = tracer.all(*tree, rays, kMost);
        for (size_t i = 0; i < rays.size(); ++i) {
            std::vector<Hit> wanted = referenceCrossings(world, rays[i]);
            ASSERT_LE(wanted.size(), kMost);
            // Hits whose exact t round to the same float may come in another order where one is off by a rounding.
            std::vector<uint32_t> numbers, wantedNumbers;
            for (uint32_t k = 0; k < kMost && found.hits[i * kMost + k].prim != kNone; ++k) {
                const Hit& hit = found.hits[i * kMost + k];
                ASSERT_LT(k, wanted.size()) << "ray " << i;
                ASSERT_NEAR(hit.t, wanted[k].t, 2.4e-7 * wanted[k].t) << "ray " << i;
                numbers.push_back(hit.prim);
            }
            for (const Hit& hit : wanted) wantedNumbers.push_back(hit.prim);
            std::sort(numbers.begin(), numbers.end());
            std::sort(wantedNumbers.begin(), wantedNumbers.end());
            ASSERT_EQ(numbers, wantedNumbers) << "ray " << i;
            hits += numbers.size();
        }
    }
    EXPECT_GT(hits, 20000u);
}

TEST(TraceAll, TakesAnyNumberOfRaysInBatches) {
    const TriangleSet set = mixedSet(100, 7);
    TraceLimits limits;
    limits.batch = 100;
    Tracer tracer(device(), limits);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    for (uint32_t n : {0u, 1u, 100u, 1001u}) {
        const std::vector<Ray> rays = mixedRays(n, n);
        const Tracer::Result found = tracer.all(*tree, rays, 40);
        ASSERT_EQ(found.hits.size(), 40u * n);
        for (size_t i = 0; i < n; ++i) {
            std::vector<Hit> wanted = bruteCrossings(set, rays[i]);
            wanted.resize(40, missedHit());
            for (size_t k = 0; k < 40; ++k) ASSERT_TRUE(areSame(found.hits[40 * i + k], wanted[k])) << "ray " << i;
        }
    }
}

TEST(TraceAll, ReachesTheDeepestLeaf) {
    const DeepChain chain = deepChain();
    expectAll(chain.set, chain.tree, chain.rays, 8);
}

}  // namespace
}  // namespace cleave::test
