// Rays through meshes in places against the same through the copied scene: hits are compared with ==.
#include "instances/instances.h"

#include <gtest/gtest.h>

#include <cstring>

#include "builders/builders.h"
#include "judge/oracle.h"
#include "run/gpu_builder.h"
#include "run/tracer.h"
#include "support/device.h"
#include "support/instanced_scene.h"
#include "support/runners.h"
#include "support/scenes.h"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

struct Both {
    std::vector<Triangle> world;
    TriangleSet set;
    std::shared_ptr<DeviceTree> copied;
    DeviceInstances placed;
    size_t places = 0;
};

Both bothOf(const Scene& scene, GpuBuilder* builder = nullptr, size_t fewest = 64) {
    Both both;
    both.world = pose(scene).triangles;
    both.set = makeTriangleSet(both.world);
    both.copied = uploadTree(device(), both.set, buildExact(both.set, BuildSettings{}));
    SharedPose shared = poseShared(scene, {}, sharingOf(scene, fewest));
    const Instances made = instancesOf(shared);
    std::vector<std::shared_ptr<DeviceTree>> trees;
    const auto add = [&](const std::vector<Triangle>& triangles, std::span<const uint32_t> numbers) {
        if (builder) {
            const DeviceTriangles onDevice(device(), triangles);
            trees.push_back(numbers.empty() ? builder->build(onDevice, {}).tree
                                            : builder->buildNumbered(onDevice, {}, numbers).tree);
            return;
        }
        const TriangleSet set = makeTriangleSet(triangles);
        trees.push_back(uploadTree(device(), set, buildExact(set, BuildSettings{}), numbers));
    };
    for (const std::vector<Triangle>& mesh : made.meshes) add(mesh, {});
    if (!made.rest.empty()) add(made.rest, made.restNumbers);
    both.places = made.places.size();
    both.placed = placeTrees(device(), std::move(trees), made.nodes, made.places, made.treeOf, made.exponent);
    return both;
}

float scaleOf(const Both& both) { return std::ldexp(1.0f, both.set.exponent); }

vec3 anyDirection(std::mt19937& random) {
    std::normal_distribution<float> gauss;
    const float x = gauss(random), y = gauss(random), z = gauss(random);
    return {x, y, z};
}

// Rays of every kind that may go wrong, aimed at the triangles of the copied scene.
std::vector<Ray> raysAt(const Both& both, uint32_t n, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const float scale = scaleOf(both);
    std::vector<Ray> rays;
    for (uint32_t i = 0; i < n; ++i) {
        const Triangle& t = both.world[both.set.included[random() % both.set.included.size()]];
        const float u = unit(random), v = unit(random) * (1.0f - u);
        vec3 target = t.a + u * (t.b - t.a) + v * (t.c - t.a);
        if (i % 5 == 1) target = t.a;
        if (i % 5 == 2) target = 0.5f * (t.b + t.c);
        vec3 direction = anyDirection(random);
        if (i % 7 == 1) direction[static_cast<int>(random() % 3)] = 0.0f;
        if (i % 7 == 2) {
            direction = vec3(0.0f);
            direction[static_cast<int>(random() % 3)] = i % 2 == 0 ? 1.0f : -1.0f;
        }
        if (i % 7 == 3) direction = (t.b - t.a) / std::max(scale * 1e-6f, glm::length(t.b - t.a)) + direction * 1e-4f;
        if (i % 7 == 4) direction[static_cast<int>(random() % 3)] *= 1e-12f;
        if (direction == vec3(0.0f)) direction = vec3(1.0f, 0.0f, 0.0f);
        const float far[] = {0.0f, 0.3f, 3.0f, 300.0f, 3e5f, 3e8f};
        const float distance = far[i % 6] * scale;
        Ray ray;
        ray.direction = direction * (i % 11 == 0 ? scale * 1e-5f : 1.0f);
        ray.origin = target - direction * distance;
        ray.tMin = 0.0f;
        ray.tMax = i % 9 == 0 ? 1.5f * scale : infinity();
        if (i % 13 == 0) ray.tMin = 0.3f * scale;
        rays.push_back(ray);
    }
    return rays;
}

void expectSame(const Both& both, const std::vector<Ray>& rays, TraceMode mode) {
    Tracer& tracer = sharedTracer();
    const Tracer::Result want = tracer.trace(*both.copied, rays, mode);
    const Tracer::Result got = tracer.trace(both.placed, rays, mode);
    ASSERT_EQ(got.cappedRays, 0u);
    size_t hits = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        hits += want.hits[i].prim != kNone ? 1 : 0;
        if (mode.query == Query::any)
            ASSERT_EQ(want.hits[i].prim == kNone, got.hits[i].prim == kNone) << "ray " << i;
        else
            ASSERT_EQ(std::memcmp(&want.hits[i], &got.hits[i], sizeof(Hit)), 0)
                << "ray " << i << ": " << got.hits[i].prim << " at " << got.hits[i].t << ", not " << want.hits[i].prim
                << " at " << want.hits[i].t;
    }
    EXPECT_GT(hits, rays.size() / 4);
}

// Hits are still there where the ray begins and ends at their t, which is rounded.
void expectEndsToCount(const Both& both, std::vector<Ray> rays, TraceMode mode) {
    Tracer& tracer = sharedTracer();
    const Tracer::Result hits = tracer.trace(*both.copied, rays, mode);
    for (size_t i = 0; i < rays.size(); ++i)
        if (hits.hits[i].prim != kNone) rays[i].tMin = rays[i].tMax = hits.hits[i].t;
    expectSame(both, rays, mode);
}

// Two meshes and what is not shared, of all sizes and shapes, mirrored, sheared by nested nodes, across each other.
InstancedScene anyScene(uint32_t seed, double size, double least) {
    std::mt19937 random(seed);
    InstancedScene made;
    const uint32_t rock = made.mesh(mixedTriangles(150, seed)), tree = made.mesh(mixedTriangles(64, seed + 10));
    const uint32_t alone = made.mesh(mixedTriangles(70, seed + 20)), tiny = made.mesh(mixedTriangles(3, seed));
    made.node(alone, placeAt(glm::dvec3(0.0), glm::dmat3(size)));
    for (int i = 0; i < 14; ++i) {
        const double part = std::pow(least, double(i % 5) / 4.0);
        const uint32_t at =
            made.node(i % 2 == 0 ? rock : tree, placeAt(anyPoint(random, 2.0 * size), anyAxes(random, part * size)));
        made.node(i % 3 == 0   ? tree
                  : i % 3 == 1 ? rock
                               : tiny,
                  placeAt(anyPoint(random, 1.0), anyAxes(random, 0.5)), at);
    }
    return made;
}

TEST(InstancesOnDevice, AnswerAsTheCopiedScene) {
    for (uint32_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Both both = bothOf(anyScene(seed, 1.0, 0.01).scene);
        EXPECT_GT(both.places, 20u);
        expectSame(both, raysAt(both, 8000, seed), {.traversal = Traversal::stack});
        if (HasFatalFailure()) return;
        expectEndsToCount(both, raysAt(both, 4000, seed), {.traversal = Traversal::stack});
        if (HasFatalFailure()) return;
    }
}

TEST(InstancesOnDevice, AnswerSoInEveryMode) {
    const Both both = bothOf(anyScene(4, 1.0, 0.01).scene);
    const std::vector<Ray> rays = raysAt(both, 3000, 4);
    for (const Traversal traversal : {Traversal::restart, Traversal::shortStack, Traversal::stack})
        for (const Query query : {Query::closest, Query::any}) {
            SCOPED_TRACE(std::to_string(int(traversal)) + ", " + std::to_string(int(query)));
            expectSame(both, rays, {.query = query, .traversal = traversal});
            if (HasFatalFailure()) return;
        }
    expectSame(both, rays, {.traversal = Traversal::stack, .test = TriangleTest::unfiltered});
    expectSame(both, rays, {.traversal = Traversal::stack, .countSteps = true});
}

TEST(InstancesOnDevice, AnswerSoAtEveryScale) {
    for (const double size : {1e-30, 1e-7, 1e7, 1e30}) {
        SCOPED_TRACE("size " + std::to_string(size));
        const Both both = bothOf(anyScene(5, size, 0.01).scene);
        EXPECT_GT(both.places, 20u);
        expectSame(both, raysAt(both, 6000, 5), {.traversal = Traversal::stack});
        if (HasFatalFailure()) return;
    }
}

// Trees of the device's builder, with numbers that have gaps between them.
TEST(InstancesOnDevice, TakeTreesOfTheDevice) {
    GpuBuilder& builder = sharedBuilder();
    const Both both = bothOf(anyScene(6, 1.0, 0.001).scene, &builder);
    expectSame(both, raysAt(both, 5000, 6), {.traversal = Traversal::stack});
}

// Small and far out, up to what is still placed: the error is a good part of a cell there.
TEST(InstancesOnDevice, AnswerSoWhereTheErrorIsLarge) {
    std::mt19937 random(8);
    InstancedScene made;
    const uint32_t rock = made.mesh(mixedTriangles(200, 8));
    for (int i = 0; i < 30; ++i) {
        glm::dmat3 axes = anyAxes(random, 2e-4);
        if (i % 2 == 0) axes[2] *= 1e3;
        made.node(rock, placeAt(glm::dvec3(0.9) + anyPoint(random, 1e-3), axes));
    }
    const Both both = bothOf(made.scene);
    EXPECT_GT(both.places, 10u);
    expectSame(both, raysAt(both, 12000, 8), {.traversal = Traversal::stack});
}

// Faces that meet, seen from the planes that they lie in.
TEST(InstancesOnDevice, AnswerSoOnAGrid) {
    std::vector<Triangle> grid;
    for (int x = 0; x < 6; ++x)
        for (int y = 0; y < 6; ++y) {
            const vec3 o(float(x), float(y), float(x % 2));
            grid.push_back({o, o + vec3(1, 0, 0), o + vec3(0, 1, 0)});
            grid.push_back({o + vec3(1, 1, 0), o + vec3(0, 1, 0), o + vec3(1, 0, 0)});
        }
    InstancedScene made;
    const uint32_t mesh = made.mesh(grid);
    const glm::dmat3 swap(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0));
    made.node(mesh, placeAt({0, 0, 0}, glm::dmat3(1.0)));
    made.node(mesh, placeAt({0, 0, 0}, glm::dmat3(1.0)));  // the same once more: ties
    made.node(mesh, placeAt({6, 0, 0}, swap));
    made.node(mesh, placeAt({0, 0, 6}, -swap * swap));
    const Both both = bothOf(made.scene);
    std::mt19937 random(3);
    std::vector<Ray> rays = raysAt(both, 10000, 9);
    for (int i = 0; i < 10000; ++i) {
        Ray ray;
        const auto whole = [&] { return float(int(random() % 14) - 1) * 0.5f; };
        const float x = whole(), y = whole(), z = whole();
        ray.origin = {x, y, z};
        ray.direction = vec3(0.0f);
        ray.direction[static_cast<int>(random() % 3)] = i % 2 == 0 ? 1.0f : -1.0f;
        if (i % 4 == 0) ray.direction[static_cast<int>(random() % 3)] = 1.0f;
        ray.tMin = 0.0f;
        ray.tMax = infinity();
        rays.push_back(ray);
    }
    expectSame(both, rays, {.traversal = Traversal::stack});
}

// Those of our own whose meshes stand in two places.
TEST(InstancesOnDevice, AnswerSoInSceneFiles) {
    size_t seen = 0;
    for (const char* name : {"cornell", "shells", "still_life"}) {
        SCOPED_TRACE(name);
        const Scene scene = loadGltf(fs::path(CLEAVE_SOURCE) / "scenes" / (std::string(name) + ".glb"));
        if (sharingOf(scene, 1).copies == 0) continue;
        const Both both = bothOf(scene, nullptr, 1);
        expectSame(both, raysAt(both, 400, 11), {.traversal = Traversal::shortStack});
        if (HasFatalFailure()) return;
        seen++;
    }
    EXPECT_EQ(seen, 3u);
}

TEST(InstancesOnDevice, AnswerNothingWithoutPlaces) {
    const DeviceInstances none = placeTrees(device(), {}, {}, {}, {}, 0);
    Tracer& tracer = sharedTracer();
    const Tracer::Result got = tracer.trace(none, std::vector<Ray>(3, {vec3(0.0f), 0.0f, vec3(1.0f), 1.0f}));
    for (const Hit& hit : got.hits) EXPECT_EQ(hit.prim, kNone);
}

}  // namespace
}  // namespace cleave::test
