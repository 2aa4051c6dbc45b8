#include "support/trace_cases.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "builders/builders.h"
#include "judge/oracle.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"

namespace cleave::test {

namespace {

uint64_t invalidOf(const std::vector<Ray>& rays) {
    uint64_t n = 0;
    for (const Ray& r : rays) n += !isValidRay(r);
    return n;
}

}  // namespace

std::vector<Ray> mixedRays(uint32_t n, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<Ray> rays;
    for (uint32_t i = 0; i < n; i++) {
        Ray r{};
        for (int k = 0; k < 3; k++) {
            r.origin[k] = 3.0f * unit(random) - 1.0f;
            r.direction[k] = 2.0f * unit(random) - 1.0f;
        }
        r.tMin = 0.0f;
        r.tMax = infinity();
        if (i % 3 == 1) {  // along an axis, through points of a grid
            const int axis = static_cast<int>(i / 3 % 3);
            const float sign = i % 2 == 0 ? 1.0f : -1.0f;
            r.origin = glm::round(r.origin * 16.0f) / 16.0f;
            r.direction = glm::vec3(i % 5 == 0 ? -0.0f : 0.0f);
            r.direction[axis] = sign;
            if (i % 4 == 0) r.direction[(axis + 1) % 3] = 0.5f;
        }
        if (i % 11 == 0) r.direction = r.direction * 1e-30f;
        if (i % 13 == 0) r.direction = r.direction * 1e30f;
        if (i % 7 == 0) r.tMax = 0.7f;
        if (i % 8 == 0) r.tMin = 0.3f;
        if (i % 50 == 49) r.direction = glm::vec3(0.0f);
        if (i % 50 == 48) r.origin.y = std::numeric_limits<float>::quiet_NaN();
        if (i % 50 == 47) r.tMin = -1.0f;
        rays.push_back(r);
    }
    return rays;
}

void expectAnswers(const TriangleSet& set, const KdTree& tree, const std::vector<Ray>& rays, Traversal traversal) {
    Tracer& tracer = sharedTracer();
    const auto onDevice = uploadTree(device(), set, tree);
    const Tracer::Result closest = tracer.trace(*onDevice, rays, {.traversal = traversal});
    const Tracer::Result counted = tracer.trace(*onDevice, rays, {.traversal = traversal, .countSteps = true});
    const Tracer::Result any = tracer.trace(*onDevice, rays, {.query = Query::any, .traversal = traversal});
    EXPECT_EQ(closest.cappedRays, 0u);
    EXPECT_EQ(closest.invalidRays, invalidOf(rays));
    for (size_t i = 0; i < rays.size(); i++) {
        const Hit brute = bruteForce(set, rays[i], Query::closest);
        const Hit walked = stackWalk(tree, set, rays[i], Query::closest);
        ASSERT_EQ(std::memcmp(&brute, &walked, sizeof(Hit)), 0) << "ray " << i;
        ASSERT_EQ(std::memcmp(&brute, &closest.hits[i], sizeof(Hit)), 0)
            << "ray " << i << ": brute " << brute.t << " " << brute.prim << ", device " << closest.hits[i].t << " "
            << closest.hits[i].prim;
        ASSERT_EQ(std::memcmp(&brute, &counted.hits[i], sizeof(Hit)), 0) << "counted ray " << i;
        ASSERT_EQ(brute.prim == kNone, any.hits[i].prim == kNone) << "any hit of ray " << i;
    }
}

void expectAnswersOverTrees(Traversal traversal) {
    for (uint32_t n : {0u, 1u, 33u, 500u}) {
        SCOPED_TRACE("triangles and seed " + std::to_string(n));
        const TriangleSet set = mixedSet(n, n);
        const std::vector<Ray> rays = mixedRays(2000, n);
        expectAnswers(set, buildExact(set, BuildSettings{}), rays, traversal);
        expectAnswers(set, buildSpatialMedian(set, BuildSettings{}), rays, traversal);
        if (testing::Test::HasFatalFailure()) return;
    }
}

void expectHitsAtZero(Traversal traversal) {
    constexpr int kTriangles = 500, kParts = 61;
    constexpr uint32_t kSeed = 9;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    std::mt19937 random(kSeed);
    const auto whole = [&random](int bits) { return static_cast<int>(random() >> (32 - bits)) - (1 << (bits - 1)); };
    const auto point = [&whole](int bits) {
        const int x = whole(bits), y = whole(bits);
        return glm::ivec3(x, y, whole(bits));
    };
    const auto scaled = [](const glm::ivec3& p) { return vec3(p) * 0x1p-24f; };
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
    for (int n = 0; n < kTriangles; n++) {
        const glm::ivec3 a = point(23), e = point(17), f = point(17);
        triangles.push_back({scaled(a), scaled(a + kParts * e), scaled(a + kParts * f)});
        for (int i = 1; i + 1 < kParts; i += 7)
            rays.push_back({scaled(a + i * e + (kParts - i - 1) * f), 0.0f, vec3(point(20)) * 0x1p-20f, infinity()});
    }
    const TriangleSet set = makeTriangleSet(triangles);
    const KdTree tree = buildExact(set, BuildSettings{});
    expectAnswers(set, tree, rays, traversal);
    Tracer& tracer = sharedTracer();
    const Tracer::Result result = tracer.trace(*uploadTree(device(), set, tree), rays, {.traversal = traversal});
    const size_t perTriangle = rays.size() / kTriangles;
    for (size_t i = 0; i < rays.size(); i++) {
        ASSERT_EQ(result.hits[i].t, 0.0f) << "ray " << i;
        ASSERT_LE(result.hits[i].prim, i / perTriangle) << "ray " << i;
    }
}

void expectSameHits(const std::vector<Hit>& got, const std::vector<Hit>& want, Query query) {
    ASSERT_EQ(got.size(), want.size());
    for (size_t i = 0; i < want.size(); i++) {
        if (query == Query::any)
            ASSERT_EQ(got[i].prim == kNone, want[i].prim == kNone) << "ray " << i;
        else
            ASSERT_EQ(std::memcmp(&got[i], &want[i], sizeof(Hit)), 0)
                << "ray " << i << ": triangle " << got[i].prim << ", not " << want[i].prim;
    }
}

DeepChain deepChain() {
    std::vector<Triangle> triangles;
    KdTree tree;
    const uint32_t depth = kMaxDepth;
    for (uint32_t i = 0; i <= depth; i++) {
        const float x = static_cast<float>(depth - i) / 64.0f + 1.0f / 128.0f;
        triangles.push_back({{x, 0.0f, 0.0f}, {x, 1.0f, 0.0f}, {x, 0.0f, 1.0f}});
    }
    const TriangleSet set = makeTriangleSet(triangles);
    // Inner node i cuts off triangle i on its right; its left child is inner node i + 1.
    tree.exponent = set.exponent;
    tree.bounds = set.bounds;
    tree.nodes.resize(2 * depth + 1);
    uint32_t node = 0;
    for (uint32_t i = 0; i < depth; i++) {
        const uint32_t child = 2 * i + 1;
        const float plane = timesPowerOfTwo(static_cast<float>(depth - i) / 64.0f, -set.exponent);
        tree.nodes[node] = innerNode(0, plane, child);
        tree.nodes[child + 1] = leafNode(i, 1);
        tree.leafTriangles.push_back(i);
        node = child;
    }
    tree.leafTriangles.push_back(depth);
    tree.nodes[node] = leafNode(depth, 1);
    std::vector<Ray> rays;
    for (uint32_t i = 0; i <= depth; i++) {
        const float x = static_cast<float>(depth - i) / 64.0f;
        for (const float sign : {1.0f, -1.0f}) {
            const float start = sign > 0.0f ? x : x + 1.0f / 64.0f;
            rays.push_back({{start, 0.25f, 0.25f}, 0.0f, {sign, 0.0f, 0.0f}, infinity()});
            rays.push_back({{sign > 0.0f ? -1.0f : 2.0f, 0.25f, 0.25f}, 0.0f, {sign, 0.0f, 1e-3f}, infinity()});
            rays.push_back({{sign > 0.0f ? -1.0f : 2.0f, 2.0f, 0.25f}, 0.0f, {sign, -1e-3f, 0.0f}, infinity()});
            rays.push_back({{x, 0.2f, -1.0f}, 0.0f, {1e-7f * sign, 0.0f, 1.0f}, infinity()});
        }
    }
    return {set, tree, rays};
}

}  // namespace cleave::test
