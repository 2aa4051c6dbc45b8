// The trace kernel against the plainest walk and against brute force: hits are compared with ==.
#include <gtest/gtest.h>

#include <cstring>

#include "kdtree/builders.h"
#include "kdtree/oracle.h"
#include "pass/tracer.h"
#include "support/device.h"
#include "support/scenes.h"
#include "twin/twin_builder.h"

namespace cleave::test {

namespace {

// Rays of every kind: random ones, axis-parallel ones through grid points, zero and -0 components, in planes of the
// grid, from vertices, with short intervals, of any length of direction; and some that are none.
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

uint64_t invalidOf(const std::vector<Ray>& rays) {
    uint64_t n = 0;
    for (const Ray& r : rays) n += !isValidRay(r);
    return n;
}

void expectAnswers(const TriangleSet& set, const KdTree& tree, const std::vector<Ray>& rays) {
    Tracer tracer(device());
    const auto onDevice = uploadTree(device(), uploadTriangles(device(), set), tree);
    const Tracer::Result closest = tracer.trace(*onDevice, rays, Query::closest);
    const Tracer::Result counted = tracer.trace(*onDevice, rays, Query::closest, true);
    const Tracer::Result any = tracer.trace(*onDevice, rays, Query::any);
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

}  // namespace

TEST(Trace, EqualsBruteForceOverEveryTree) {
    for (uint32_t n : {0u, 1u, 2u, 33u, 500u}) {
        for (uint32_t seed = 1; seed <= 3; seed++) {
            SCOPED_TRACE("triangles " + std::to_string(n) + ", seed " + std::to_string(seed));
            const TriangleSet set = mixedSet(n, seed);
            const std::vector<Ray> rays = mixedRays(2000, seed);
            expectAnswers(set, buildTwin(set, BuildSettings{}).tree, rays);
            expectAnswers(set, buildExact(set, BuildSettings{}), rays);
            expectAnswers(set, buildBrute(set), rays);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(Trace, TakesAnyNumberOfRays) {
    const TriangleSet set = mixedSet(100, 7);
    const KdTree tree = buildExact(set, BuildSettings{});
    for (uint32_t n : kSizes) {
        SCOPED_TRACE("rays " + std::to_string(n));
        Tracer tracer(device());
        const std::vector<Ray> rays = mixedRays(n, n);
        const auto onDevice = uploadTree(device(), uploadTriangles(device(), set), tree);
        const Tracer::Result result = tracer.trace(*onDevice, rays, Query::closest);
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
    expectAnswers(set, tree, {{{0.2f, 0.2f, 1.0f}, 0.0f, {0, 0, -1}, infinity()}});
}

// A chain of planes down to the deepest leaf that the trail can hold: both words of it are used, and each cell on the
// way holds a triangle, so that a cell that is passed over shows.
TEST(Trace, ReachesTheDeepestLeaf) {
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
    expectAnswers(set, tree, rays);
}

}  // namespace cleave::test
