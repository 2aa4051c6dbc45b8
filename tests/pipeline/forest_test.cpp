// Several trees over one scene: what rays hit, and what pictures show, is what it is with one tree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "builders/builders.h"
#include "run/gpu_builder.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/small_picture.h"
#include "support/trace_cases.h"

namespace cleave::test {
namespace {

// Trees over every `count`-th triangle, by the device and by the exact builder in turn.
struct Wood {
    std::vector<std::shared_ptr<DeviceTree>> trees;

    Wood(const std::vector<Triangle>& world, uint32_t count) {
        const DeviceTriangles triangles(device(), world);
        GpuBuilder& builder = sharedBuilder();
        for (uint32_t first = 0; first < count; first++) {
            std::vector<uint32_t> list;
            for (uint32_t i = first; i < world.size(); i += count) list.push_back(i);
            const TriangleSet set = makeTriangleSet(trianglesOf(world, list));
            trees.push_back(first % 2 == 0 ? builder.build(triangles, BuildSettings{}, list).tree
                                           : uploadTree(device(), set, buildExact(set, BuildSettings{}), list));
        }
    }
    Forest forest() const {
        std::vector<const DeviceTree*> all;
        for (const auto& tree : trees) all.push_back(tree.get());
        return Forest(std::move(all));
    }
};

std::shared_ptr<DeviceTree> oneTree(const std::vector<Triangle>& world) {
    const TriangleSet set = makeTriangleSet(world);
    return uploadTree(device(), set, buildExact(set, BuildSettings{}));
}

TEST(Forest, AnswersAsOneTreeDoes) {
    constexpr uint32_t kSeed = 21;
    std::vector<Triangle> world = mixedTriangles(900, kSeed);
    for (size_t i = 0; i + 1 < world.size(); i += 7) world[i + 1] = world[i];  // ties across trees
    const std::vector<Ray> rays = mixedRays(4000, kSeed);
    const auto one = oneTree(world);
    const Wood wood(world, 3);
    Tracer usual(device()), limited(device(), {.batch = 512, .stepLimit = 7, .mostDispatches = 1u << 20});
    for (const Query query : {Query::closest, Query::any})
        for (const Traversal traversal : {Traversal::restart, Traversal::shortStack, Traversal::stack}) {
            SCOPED_TRACE(static_cast<int>(traversal));
            const TraceMode mode{query, traversal};
            const Tracer::Result want = usual.trace(*one, rays, mode);
            for (Tracer* tracer : {&usual, &limited}) {
                const Tracer::Result got = tracer->trace(wood.forest(), rays, mode);
                expectSameHits(got.hits, want.hits, query);
                EXPECT_EQ(got.invalidRays, want.invalidRays) << "each is counted once";
                EXPECT_GT(got.invalidRays, 0u);
                EXPECT_EQ(got.cappedRays, 0u);
            }
        }
}

// Every tree has a scale of its own.
TEST(Forest, AnswersAsOneTreeDoesAtAnyScale) {
    constexpr uint32_t kSeed = 22;
    for (const int apart : {-40, 12, 40}) {
        std::vector<Triangle> world = mixedTriangles(300, kSeed);
        for (size_t i = 1; i < world.size(); i += 2) world[i] = scaledTriangle(world[i], apart);
        const auto one = oneTree(world);
        const Wood wood(world, 2);
        EXPECT_EQ(wood.forest().exponent(), one->header.exponent);
        const Box got = wood.forest().bounds(), want = one->bounds();
        EXPECT_EQ(std::memcmp(&got, &want, sizeof(Box)), 0);
        std::vector<Ray> rays = mixedRays(3000, kSeed);
        for (size_t i = 1; i < rays.size(); i += 2) {
            rays[i].origin = timesPowerOfTwo(rays[i].origin, apart);
            rays[i].direction = timesPowerOfTwo(rays[i].direction, apart);
        }
        Tracer& tracer = sharedTracer();
        expectSameHits(tracer.trace(wood.forest(), rays).hits, tracer.trace(*one, rays).hits, Query::closest);
    }
}

// Of directions so long that the t of all hits is below the smallest float, and 0 in the answer.
TEST(Forest, TellsHitsApartWhoseTIsBelowTheSmallestFloat) {
    constexpr uint32_t kSeed = 26;
    const std::vector<Triangle> world = mixedTriangles(300, kSeed);
    const auto one = oneTree(world);
    const Wood wood(world, 3);
    std::vector<Ray> rays = mixedRays(3000, kSeed);
    for (Ray& ray : rays) {
        const int up = 126 - directionExponent(ray);
        ray.direction = timesPowerOfTwo(ray.direction, up);
        ray.origin = timesPowerOfTwo(ray.origin, -6);
    }
    Tracer& tracer = sharedTracer();
    const std::vector<Hit> want = tracer.trace(*one, rays).hits;
    EXPECT_GT(std::ranges::count_if(want, [](const Hit& hit) { return hit.prim != kNone && hit.t == 0.0f; }), 100);
    expectSameHits(tracer.trace(wood.forest(), rays).hits, want, Query::closest);
}

TEST(Forest, CountsTheStepsOfAllItsTrees) {
    const std::vector<Triangle> world = mixedTriangles(400, 23);
    const std::vector<Ray> rays = mixedRays(1000, 23);
    const Wood wood(world, 2);
    Tracer& tracer = sharedTracer();
    const TraceMode mode{.countSteps = true};
    const Tracer::Result first = tracer.trace(*wood.trees[0], rays, mode);
    const Tracer::Result second = tracer.trace(*wood.trees[1], rays, mode, first.hits);
    const Tracer::Result both = tracer.trace(wood.forest(), rays, mode);
    for (size_t i = 0; i < rays.size(); i++) {
        ASSERT_EQ(both.steps[i].inner, first.steps[i].inner + second.steps[i].inner);
        ASSERT_EQ(both.steps[i].triangles, first.steps[i].triangles + second.steps[i].triangles);
        const bool isSecond = second.hits[i].prim != first.hits[i].prim;
        ASSERT_EQ(both.steps[i].hitLeaf, isSecond ? second.steps[i].hitLeaf : first.steps[i].hitLeaf);
    }
}

// Whether rays look through something, go on where a step limit ended them, or neither.
TEST(Forest, ShowsWhatOneTreeShows) {
    SmallPicture small = smallPicture(2000, 24);
    PictureRequest& request = small.request;
    const DeviceTriangles triangles(device(), small.world);
    const auto one = oneTree(small.world);
    const Wood wood(small.world, 2);
    const DeviceSurfaces opaque(device(), small.data), seenThrough(device(), blended(small.data));
    Tracer& tracer = sharedTracer();
    Renderer usual(device(), tracer), limited(device(), tracer, {.stepLimit = 9});
    for (const DeviceSurfaces* surfaces : {&opaque, &seenThrough})
        for (const View view : {View::shaded, View::path, View::normals, View::depth})
            for (const Traversal traversal : {Traversal::restart, Traversal::stack}) {
                SCOPED_TRACE(static_cast<int>(view));
                request.view = view;
                request.traversal = traversal;
                request.samples = takesSamples(view) ? 2 : 1;
                request.lighting.sky = {vec3(1.0f), vec3(0.5f)};
                const Picture want = usual.render(*one, triangles, *surfaces, request);
                for (Renderer* renderer : {&usual, &limited}) {
                    if (renderer == &limited && view == View::path) continue;  // whose rays are not interrupted
                    const Picture got = renderer->render(wood.forest(), triangles, *surfaces, request);
                    EXPECT_EQ(got.pixels, want.pixels);
                    EXPECT_EQ(got.cappedRays, 0u);
                    EXPECT_EQ(got.scaleHigh, want.scaleHigh);
                }
            }
}

// A tree of one leaf has kernels of its own.
TEST(Forest, ShowsTheSameByASingleLeaf) {
    SmallPicture small = smallPicture(kFewInLeaf, 27);
    for (Triangle& t : small.world) t = {t.a, t.a + 2.0f * (t.b - t.a), t.a + 2.0f * (t.c - t.a)};
    const TriangleSet set = makeTriangleSet(small.world);
    const DeviceTriangles triangles(device(), small.world);
    const auto leaf = uploadTree(device(), set, buildBrute(set));
    const auto tree = oneTree(small.world);
    ASSERT_TRUE(leaf->isSingle() && !tree->isSingle());
    SurfaceData backs = small.data;
    backs.materials[0].flags = kMaterialSingleSided;
    backs.singleSided = true;
    const DeviceSurfaces opaque(device(), small.data), half(device(), blended(small.data)), front(device(), backs);
    Tracer tracer(device());
    Renderer renderer(device(), tracer);
    PictureRequest& request = small.request;
    request.lighting.sky = {vec3(1.0f), vec3(0.5f)};
    for (const DeviceSurfaces* surfaces : {&opaque, &half, &front})
        for (const View view : {View::shaded, View::path}) {
            SCOPED_TRACE(static_cast<int>(view));
            request.view = view;
            request.samples = 2;
            const Picture want = renderer.render(*tree, triangles, *surfaces, request);
            EXPECT_EQ(renderer.render(*leaf, triangles, *surfaces, request).pixels, want.pixels);
        }
}

// The views of a tree show the sum of all trees.
TEST(Forest, ShowsTheStepsOfAllItsTrees) {
    SmallPicture small = smallPicture(2000, 25);
    const DeviceTriangles triangles(device(), small.world);
    const Wood wood(small.world, 2);
    const DeviceSurfaces surfaces(device(), small.data);
    Renderer& renderer = sharedRenderer();
    small.request.view = View::steps;
    const Picture both = renderer.render(wood.forest(), triangles, surfaces, small.request);
    const std::vector<Ray> rays = renderer.readRays();
    std::vector<uint32_t> counts;
    for (const StepCount& s : sharedTracer().trace(wood.forest(), rays, {.countSteps = true}).steps)
        counts.push_back(s.inner + s.leaves);
    std::ranges::sort(counts);
    EXPECT_EQ(both.scaleHigh, static_cast<float>(counts[scaleRank(static_cast<uint32_t>(counts.size()))]));
}

}  // namespace
}  // namespace cleave::test
