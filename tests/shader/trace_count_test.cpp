// The kernel trace_count against its twin; and over closed surfaces, where counts are even and what enters leaves.
#include <gtest/gtest.h>

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

void expectCounts(const TriangleSet& set, const KdTree& tree, const std::vector<Ray>& rays) {
    Tracer& tracer = sharedTracer();
    const auto onDevice = uploadTree(device(), set, tree);
    const Tracer::Counts counts = tracer.count(*onDevice, rays), windings = tracer.count(*onDevice, rays, true);
    ASSERT_EQ(counts.counts.size(), rays.size());
    uint64_t invalid = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(counts.counts[i], static_cast<int32_t>(bruteCrossings(set, rays[i]).size())) << "ray " << i;
        ASSERT_EQ(windings.counts[i], bruteWinding(set, rays[i])) << "ray " << i;
        invalid += isValidRay(rays[i]) ? 0 : 1;
    }
    EXPECT_EQ(counts.invalidRays, invalid);
    EXPECT_EQ(windings.invalidRays, invalid);
}

TEST(TraceCount, EqualsBruteForceOverEveryTree) {
    for (uint32_t n : {0u, 1u, 2u, 33u, 500u}) {
        for (uint32_t seed = 1; seed <= 3; seed++) {
            SCOPED_TRACE("triangles " + std::to_string(n) + ", seed " + std::to_string(seed));
            const TriangleSet set = mixedSet(n, seed);
            const std::vector<Ray> rays = mixedRays(1000, seed);
            expectCounts(set, buildTwin(set, BuildSettings{}).tree, rays);
            expectCounts(set, buildBrute(set), rays);
            if (HasFatalFailure()) return;
        }
    }
}

// More than one walk collects.
TEST(TraceCount, CountsManyAtTheSamePlace) {
    const std::vector<Triangle> stack(45, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    expectCounts(makeTriangleSet(stack), buildBrute(makeTriangleSet(stack)), raysAt(5, 100, -0.5f, 0.5f));
}

TEST(TraceCount, IsEvenOverClosedSurfaces) {
    uint64_t crossed = 0;
    for (uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const bool slivers = seed % 2 == 0;
        const std::vector<Triangle> world = slivers ? sliverStar(seed, 5) : latticeBlob(seed, 5, 6);
        const TriangleSet set = makeTriangleSet(world);
        Random random(seed);
        std::vector<Ray> lines;
        for (int i = 0; i < 17000; ++i) lines.push_back(aimedAt(world, random, slivers ? 1.0f : 6.0f));
        Tracer& tracer = sharedTracer();
        const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
        const Tracer::Counts counts = tracer.count(*tree, lines), windings = tracer.count(*tree, lines, true);
        for (size_t i = 0; i < lines.size(); ++i) {
            ASSERT_EQ(counts.counts[i] % 2, 0) << "line " << i;
            ASSERT_EQ(windings.counts[i], 0) << "line " << i;
            crossed += static_cast<uint64_t>(counts.counts[i]);
        }
    }
    EXPECT_GT(crossed, 1000000u);
}

// A line without an end tells how often the surface winds around its origin.
TEST(TraceCount, TellsInsideFromOutside) {
    const std::vector<Triangle> world = octasphere(4, onUnitSphere);
    const TriangleSet set = makeTriangleSet(world);
    Random random(1);
    std::vector<Ray> rays;
    for (int i = 0; i < 1000; ++i) {
        const float far = i % 2 == 0 ? 0.5f : 2.0f;
        const vec3 from = far * glm::normalize(random.point(-1.0f, 1.0f));
        rays.push_back({from, 0.0f, world[random.below(128)].a - from, infinity()});
    }
    Tracer& tracer = sharedTracer();
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const Tracer::Counts windings = tracer.count(*tree, rays, true);
    for (size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(windings.counts[i], i % 2 == 0 ? 1 : 0) << i;
}

}  // namespace
}  // namespace cleave::test
