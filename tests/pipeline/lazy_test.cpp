// A tree that is built where rays come to gives the hits and the pictures of the whole tree.
#include "run/lazy_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/build_layout.h"
#include "judge/validate.h"
#include "run/gpu_builder.h"
#include "shared/build.h"
#include "support/device.h"
#include "support/small_picture.h"
#include "support/trace_cases.h"
#include "tree/build_info.h"
#include "tree/open_nodes.h"
#include "twin/passes.h"

namespace cleave::test {
namespace {

// It lives as long as the device: pipelines take a while.
GpuBuilder& builder() {
    static std::unique_ptr<GpuBuilder> made;
    if (!made) {
        made = std::make_unique<GpuBuilder>(device(), true);
        beforeClose([] { made.reset(); });
    }
    return *made;
}

TEST(Lazy, AnswersAsTheWholeTreeDoes) {
    constexpr uint32_t kSeed = 31;
    Tracer usual(device()), limited(device(), {.batch = 512, .stepLimit = 7, .mostDispatches = 1u << 20});
    for (const uint32_t count : {40u, 300u, 6000u}) {
        const std::vector<Triangle> world = mixedTriangles(count, kSeed);
        const DeviceTriangles triangles(device(), world);
        const std::vector<Ray> rays = mixedRays(3000, kSeed);
        const Tracer::Result want = usual.trace(*builder().build(triangles, BuildSettings{}).tree, rays);
        const auto expectSame = [&](Tracer& tracer, const TraceMode& mode) {
            SCOPED_TRACE(std::to_string(count) + " triangles, traversal " +
                         std::to_string(static_cast<int>(mode.traversal)));
            const auto lazy = builder().buildLazily(triangles, BuildSettings{}, 100);
            const Tracer::Result got = tracer.trace(Forest(*lazy), rays, mode);
            expectSameHits(got.hits, want.hits, mode.query);
            EXPECT_EQ(got.invalidRays, want.invalidRays);
            EXPECT_EQ(got.cappedRays, 0u);
            EXPECT_GT(lazy->figures().expansions, count == 6000 ? 1u : 0u) << "rays waited";
        };
        for (const Traversal traversal : {Traversal::restart, Traversal::shortStack, Traversal::stack}) {
            expectSame(usual, {Query::closest, traversal});
            expectSame(usual, {Query::any, traversal});
            if (count == 300) expectSame(limited, {Query::closest, traversal});
        }
    }
}

// Hits whose t is below the smallest float cannot be kept while a ray waits: such a ray tests all of an open leaf.
TEST(Lazy, AnswersRaysThatCannotWait) {
    constexpr uint32_t kSeed = 32;
    std::vector<Triangle> world = mixedTriangles(3000, kSeed);
    for (Triangle& t : world) {  // so large that hits lie beyond the leaf that tells of them
        const vec3 a = t.a;
        t = {a, a + 4.0f * (t.b - a), a + 4.0f * (t.c - a)};
    }
    const DeviceTriangles triangles(device(), world);
    std::vector<Ray> rays = mixedRays(20000, kSeed);
    for (Ray& ray : rays) {
        ray.direction = timesPowerOfTwo(ray.direction, 126 - directionExponent(ray));
        ray.origin = timesPowerOfTwo(ray.origin, -6);
    }
    Tracer tracer(device());
    const std::vector<Hit> want = tracer.trace(*builder().build(triangles, BuildSettings{}).tree, rays).hits;
    EXPECT_GT(std::ranges::count_if(want, [](const Hit& hit) { return hit.prim != kNone && hit.t == 0.0f; }), 100);
    BuildSettings small;
    small.exactUpTo = 33;
    for (const Traversal traversal : {Traversal::restart, Traversal::shortStack, Traversal::stack}) {
        const auto lazy = builder().buildLazily(triangles, small, 40);
        expectSameHits(tracer.trace(Forest(*lazy), rays, {Query::closest, traversal}).hits, want, Query::closest);
        EXPECT_GT(lazy->figures().openNodes, 100u);
    }
}

TEST(Lazy, BuildsOnlyWhatRaysReach) {
    const std::vector<Triangle> world = mixedTriangles(20000, 33);
    const DeviceTriangles triangles(device(), world);
    const auto lazy = builder().buildLazily(triangles, BuildSettings{}, 200);
    const LazyFigures before = lazy->figures();
    EXPECT_GT(before.openNodes, 100u);
    EXPECT_EQ(before.stillOpen, before.openNodes);
    EXPECT_LT(before.builtShare(), 0.2);
    Tracer tracer(device());
    const std::vector<Ray> ray{{vec3(0.0f, 0.0f, -1.0f), 0.0f, vec3(0.3f, 0.3f, 1.0f), infinity()}};
    tracer.trace(Forest(*lazy), ray);
    const LazyFigures one = lazy->figures();
    EXPECT_LT(one.stillOpen, one.openNodes);
    EXPECT_GT(one.stillOpen, one.openNodes - 30);
    EXPECT_EQ(one.openNodes - one.stillOpen, one.expansions) << "a single ray waits at one node at a time";
    tracer.trace(Forest(*lazy), ray);
    EXPECT_EQ(lazy->figures().expansions, one.expansions) << "the same ray waits no more";
    lazy->expandAll();
    EXPECT_EQ(lazy->figures().stillOpen, 0u);
    EXPECT_EQ(lazy->figures().builtShare(), 1.0);
    const uint32_t all = lazy->figures().expansions;
    tracer.trace(Forest(*lazy), mixedRays(1000, 33));
    EXPECT_EQ(lazy->figures().expansions, all) << "nothing is open";
}

// Sound at every stage; once all is built about as good as the tree that is built at once.
TEST(Lazy, TreeIsSound) {
    const std::vector<Triangle> world = mixedTriangles(8000, 34);
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(device(), world);
    const KdTree whole = readBack(*builder().build(triangles, BuildSettings{}).tree);
    const auto lazy = builder().buildLazily(triangles, BuildSettings{}, 300);
    const auto expectSound = [&] {
        const KdTree tree = readBack(lazy->tree());
        const ValidationReport report = validate(tree, set, defaultDepth(8000));
        EXPECT_TRUE(report.ok()) << report.errors.front();
        EXPECT_EQ(lazy->tree().header.status, 0u);
    };
    expectSound();
    Tracer tracer(device());
    for (uint32_t i = 0; i < 3; i++) {
        tracer.trace(Forest(*lazy), mixedRays(4, 34 + i));
        expectSound();
    }
    lazy->expandAll();
    expectSound();
    const auto references = [](const KdTree& tree) {
        uint64_t sum = 0;
        for (const KdNode& node : tree.nodes) sum += isLeaf(node) ? leafCount(node) : 0;
        return static_cast<double>(sum);
    };
    const KdTree tree = readBack(lazy->tree());
    EXPECT_NEAR(references(tree) / references(whole), 1.0, 0.02);
    EXPECT_NEAR(static_cast<double>(tree.nodes.size()) / static_cast<double>(whole.nodes.size()), 1.0, 0.02);
}

// The twin builds the same in the same steps.
TEST(Lazy, EqualsTwin) {
    const std::vector<Triangle> world = mixedTriangles(9000, 35);
    const DeviceTriangles triangles(device(), world);
    const auto lazy = builder().buildLazily(triangles, BuildSettings{}, 500);
    Geometry geometry = triangles.geometry();
    BuildInfo info = buildInfo(BuildSettings{});
    info.geometries = &geometry;
    info.geometryCount = 1;
    info.openUpTo = 500;
    BuildArrays twin = makeArrays(world, {}, info);
    for (const twin::Pass& pass : twin::setupPasses()) pass.run(twin, 0);
    twin::runLevels(twin, choiceOf(info));
    const auto expectSame = [&] {
        const TreeHeader& header = lazy->tree().header;
        ASSERT_EQ(header.nodeCount, twin.header.nodeCount);
        ASSERT_EQ(header.leafRefCount, twin.header.leafRefCount);
        EXPECT_EQ(header.levels, twin.header.levels);
        const KdTree tree = readBack(lazy->tree());
        EXPECT_EQ(std::memcmp(tree.nodes.data(), twin.tree.data(), tree.nodes.size() * sizeof(KdNode)), 0);
        EXPECT_TRUE(std::ranges::equal(tree.leafTriangles, std::span(twin.leafRefs.data(), header.leafRefCount)));
    };
    expectSame();
    const std::vector<OpenNode> open =
        openNodesOf(twin.header.bounds, {twin.tree.data(), twin.header.nodeCount}, twin.state.scene.included, info);
    ASSERT_GT(open.size(), 10u);
    beginExpansion(twin, info, open);
    for (const twin::Pass& pass : twin::expandPasses()) pass.run(twin, 0);
    twin::runLevels(twin, choiceOf(info, true));
    lazy->expandAll();
    expectSame();
}

// Where memory is short the tree moves to more; where there is no more, leaves stay large.
TEST(Lazy, TakesMoreMemoryWhereItMay) {
    const std::vector<Triangle> world = mixedTriangles(5000, 36);
    const DeviceTriangles triangles(device(), world);
    const std::vector<Ray> rays = mixedRays(2000, 36);
    Tracer tracer(device());
    const auto want = tracer.trace(*builder().build(triangles, BuildSettings{}).tree, rays).hits;
    const auto generous = builder().buildLazily(triangles, BuildSettings{}, 400);
    generous->expandAll();
    const Capacity small{0, 0, 300, 20000};
    const auto grown = builder().buildLazily(triangles, BuildSettings{}, 400, small);
    expectSameHits(tracer.trace(Forest(*grown), rays).hits, want, Query::closest);
    grown->expandAll();
    EXPECT_FALSE(grown->figures().memoryLimited);
    EXPECT_GT(grown->tree().header.nodeCount, 300u);
    EXPECT_EQ(grown->tree().header.nodeCount, generous->tree().header.nodeCount);
    BuildSettings limited;
    limited.memory = 3000000;
    const auto bounded = builder().buildLazily(triangles, limited, 400);
    expectSameHits(tracer.trace(Forest(*bounded), rays).hits, want, Query::closest);
    EXPECT_TRUE(bounded->figures().memoryLimited);
    EXPECT_LE(bounded->figures().peakBytes, 3000000u);
}

// A level has room for so many references; the leaves of a tree may have more, all of which rays may reach at once.
TEST(Lazy, ExpandsAsMuchAtOnceAsALevelHolds) {
    std::vector<Triangle> world = mixedTriangles(2000, 38);
    for (Triangle& t : world) t = {t.a, t.a + 6.0f * (t.b - t.a), t.a + 6.0f * (t.c - t.a)};
    const DeviceTriangles triangles(device(), world);
    const auto lazy = builder().buildLazily(triangles, BuildSettings{}, kExactUpTo, {2000, 0, 0, 0});
    const LazyFigures before = lazy->figures();
    ASSERT_GT(before.neverBuilt, 4000u) << "there is more than a level holds";
    lazy->expandAll();
    EXPECT_GT(lazy->figures().expansions, 2u);
    EXPECT_EQ(lazy->figures().neverBuilt, 0u);
    const ValidationReport report = validate(readBack(lazy->tree()), makeTriangleSet(world), defaultDepth(2000));
    EXPECT_TRUE(report.ok()) << report.errors.front();
}

// Whether rays look through something, go on where a step limit ended them, or neither.
TEST(Lazy, ShowsWhatTheWholeTreeShows) {
    SmallPicture small = smallPicture(6000, 37);
    PictureRequest& request = small.request;
    const DeviceTriangles triangles(device(), small.world);
    const auto whole = builder().build(triangles, BuildSettings{}).tree;
    const DeviceSurfaces opaque(device(), small.data), seenThrough(device(), blended(small.data));
    Tracer tracer(device());
    Renderer usual(device(), tracer), limited(device(), tracer, {.stepLimit = 9});
    for (const DeviceSurfaces* surfaces : {&opaque, &seenThrough})
        for (const View view : {View::shaded, View::depth})
            for (const Traversal traversal : {Traversal::restart, Traversal::stack}) {
                if (surfaces == &seenThrough && view == View::depth) continue;  // which looks through nothing
                SCOPED_TRACE(static_cast<int>(view));
                request.view = view;
                request.traversal = traversal;
                request.samples = takesSamples(view) ? 2 : 1;
                const Picture want = usual.render(*whole, triangles, *surfaces, request);
                for (Renderer* renderer : {&usual, &limited}) {
                    const auto lazy = builder().buildLazily(triangles, BuildSettings{}, 200);
                    const Picture got = renderer->render(Forest(*lazy), triangles, *surfaces, request);
                    EXPECT_EQ(got.pixels, want.pixels);
                    EXPECT_EQ(got.cappedRays, 0u);
                    EXPECT_EQ(got.scaleHigh, want.scaleHigh);
                    EXPECT_GT(lazy->figures().expansions, 0u);
                }
            }
}

}  // namespace
}  // namespace cleave::test
