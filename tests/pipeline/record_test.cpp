// The recording library as its users see it: their memory, their command buffer, one submission.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <numeric>

#include "base/error.h"
#include "builders/builders.h"
#include "core/context.h"
#include "gpu/check.h"
#include "gpu/commands.h"
#include "judge/oracle.h"
#include "run/context_of.h"
#include "run/gpu_builder.h"
#include "run/ranges.h"
#include "run/renderer.h"
#include "support/device.h"
#include "support/scenes.h"
#include "support/small_picture.h"
#include "support/trace_cases.h"
#include "twin/twin_builder.h"

namespace cleave::test {

namespace {

const TraceMode kModes[] = {{Query::closest}, {Query::any}, {Query::closest, Traversal::stack}};

// A context and memory for one tree and its rays.
struct Recording {
    std::unique_ptr<Context> context = contextOf(device(), kModes, Building{.trees = true});
    Commands commands{device()};
    RangeBuffers scratch;
    Buffer tree, rays, hits, trails, counters;

    void reserve(const BuildInfo& info, const std::vector<Ray>& shot) {
        const BuildSizes sizes = buildSizes(info);
        scratch.reserve(device(), {sizes.scratch, sizes.scratchCount});
        tree = Buffer(device(), sizes.tree);
        rays = uploaded(device(), std::span<const Ray>(shot));
        hits = Buffer(device(), shot.size() * sizeof(Hit));
        trails = Buffer(device(), shot.size() * sizeof(Trail));
        const TraceCounts zero{};
        counters = uploaded(device(), std::span<const TraceCounts>(&zero, 1));
    }

    void build(const BuildInfo& info) { cmdBuild(commands.handle(), *context, info, rangeOf(tree), scratch.ranges()); }

    TraceInfo traceInfo(uint32_t count) const {
        TraceInfo info;
        info.tree = tree.address();
        info.rays = rays.address();
        info.hits = hits.address();
        info.count = count;
        info.counters = counters.address();
        return info;
    }

    // What was recorded before is visible to what is recorded after.
    void barrier() { context->state().recorder(commands.handle()).barrier(); }
    TreeHeader header() const { return tree.download<TreeHeader>(1)[0]; }
};

KdTree treeIn(Recording& r) {
    DeviceTree tree;
    tree.header = r.header();
    tree.memory = std::move(r.tree);
    return readBack(tree);
}

void expectBruteForce(const TriangleSet& set, const std::vector<Ray>& rays, const std::vector<Hit>& hits) {
    for (size_t i = 0; i < rays.size(); i++) {
        const Hit want = bruteForce(set, rays[i], Query::closest);
        ASSERT_EQ(std::memcmp(&want, &hits[i], sizeof(Hit)), 0) << "ray " << i;
    }
}

BuildInfo over(const Geometry& geometry) {
    BuildInfo info;
    info.geometries = &geometry;
    info.geometryCount = 1;
    return info;
}

}  // namespace

// Build, compaction, two traces: one command buffer, nothing read back in between.
TEST(Record, BuildsAndTracesInOneCommandBuffer) {
    const std::vector<Triangle> world = mixedTriangles(3000, 4);
    const std::vector<Ray> rays = mixedRays(3000, 5);
    const DeviceTriangles triangles(device(), world);
    const Geometry geometry = triangles.geometry();
    const BuildInfo info = over(geometry);
    Recording r;
    r.reserve(info, rays);
    const Buffer compact(device(), r.tree.size()), any(device(), rays.size() * sizeof(Hit));
    r.commands.begin();
    r.build(info);
    r.barrier();
    TraceInfo trace = r.traceInfo(static_cast<uint32_t>(rays.size()));
    cmdTrace(r.commands.handle(), *r.context, trace);
    cmdCompact(r.commands.handle(), *r.context, r.tree.address(), rangeOf(compact));
    r.barrier();
    trace.tree = compact.address();
    trace.hits = any.address();
    trace.mode.query = Query::any;
    cmdTrace(r.commands.handle(), *r.context, trace);
    r.commands.run();
    const std::vector<Hit> hits = r.hits.download<Hit>(rays.size()), anyHits = any.download<Hit>(rays.size());
    expectBruteForce(makeTriangleSet(world), rays, hits);
    for (size_t i = 0; i < rays.size(); i++) ASSERT_EQ(hits[i].prim == kNone, anyHits[i].prim == kNone) << i;
    const TreeHeader h = r.header();
    EXPECT_EQ(h.magic, TreeHeader::kMagic);
    EXPECT_EQ(h.format, kTreeFormat);
    EXPECT_EQ(h.status, 0u);
    EXPECT_EQ(h.triangleCount, world.size());
    EXPECT_LE(h.bytes, r.tree.size());
    EXPECT_EQ(h.wantedBytes, 0u);
}

// The same triangles as one list of vertices, as indices of 16 and of 32 bits, in parts, and moved by a transform that
// moves what was moved away back: the same tree.
TEST(Record, ReadsGeometryAsUsersHaveIt) {
    const std::vector<Triangle> world = mixedTriangles(700, 6);
    std::vector<vec3> moved;  // in reverse order, twice as large, and off by a power of two
    for (const Triangle& t : world)
        for (const vec3& v : {t.a, t.b, t.c}) moved.push_back(v * 2.0f);
    std::reverse(moved.begin(), moved.end());
    std::vector<uint32_t> wide(moved.size());
    std::iota(wide.rbegin(), wide.rend(), 0u);
    std::vector<uint16_t> narrow(wide.begin(), wide.end());
    narrow.resize((narrow.size() + 1) / 2 * 2);
    const float back[12] = {0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0};
    const Buffer vertices = uploaded(device(), std::span<const vec3>(moved));
    const Buffer wideIndices = uploaded(device(), std::span<const uint32_t>(wide));
    const Buffer narrowIndices = uploaded(device(), std::span<const uint16_t>(narrow));
    const Buffer transform = uploaded(device(), std::span<const float>(back));
    Geometry g;
    g.vertices = vertices.address();
    g.vertexCount = static_cast<uint32_t>(moved.size());
    g.transform = transform.address();
    g.triangleCount = static_cast<uint32_t>(world.size());
    g.indices = wideIndices.address();
    g.indexType = VK_INDEX_TYPE_UINT32;
    Geometry h = g;
    h.indices = narrowIndices.address();
    h.indexType = VK_INDEX_TYPE_UINT16;
    const DeviceTriangles plain(device(), world);
    GpuBuilder builder(device());
    const std::string want = treeHash(readBack(*builder.build(plain, BuildSettings{}).tree));
    for (const Geometry& geometry : {g, h}) {
        Recording r;
        const BuildInfo info = over(geometry);
        r.reserve(info, {});
        r.commands.begin();
        r.build(info);
        r.commands.run();
        EXPECT_EQ(treeHash(treeIn(r)), want);
    }
    Geometry first = g, second = h;
    first.triangleCount = 302;  // an even number of indices, so that the rest begins at a multiple of 4 bytes
    second.indices = narrowIndices.address() + 302 * 3 * sizeof(uint16_t);
    second.triangleCount = static_cast<uint32_t>(world.size()) - 302;
    const Geometry parts[] = {first, second};
    BuildInfo info;
    info.geometries = parts;
    info.geometryCount = 2;
    Recording r;
    r.reserve(info, {});
    r.commands.begin();
    r.build(info);
    r.commands.run();
    EXPECT_EQ(treeHash(treeIn(r)), want);
}

TEST(Record, LeavesOutTrianglesWhoseIndexIsNotThere) {
    const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<uint32_t> indices{0, 1, 2, 0, 1, 3, 0, 1, 0xFFFFFFFFu};
    const Buffer vertices = uploaded(device(), std::span<const vec3>(points));
    const Buffer corners = uploaded(device(), std::span<const uint32_t>(indices));
    Geometry g;
    g.vertices = vertices.address();
    g.vertexCount = 3;
    g.triangleCount = 3;
    g.indices = corners.address();
    g.indexType = VK_INDEX_TYPE_UINT32;
    const BuildInfo info = over(g);
    Recording r;
    r.reserve(info, {});
    r.commands.begin();
    r.build(info);
    r.commands.run();
    EXPECT_EQ(r.header().nonFinite, 2u);
    EXPECT_EQ(r.header().leafRefCount, 1u);
}

// Short of capacity, a build says so and what it wanted; the tree answers rays all the same.
TEST(Record, TellsWhatABuildWanted) {
    const std::vector<Triangle> world = mixedTriangles(2000, 3);
    const std::vector<Ray> rays = mixedRays(1000, 3);
    const DeviceTriangles triangles(device(), world);
    const Geometry geometry = triangles.geometry();
    BuildInfo info = over(geometry);
    info.capacity.nodes = 50;
    Recording r;
    r.reserve(info, rays);
    r.commands.begin();
    r.build(info);
    r.barrier();
    cmdTrace(r.commands.handle(), *r.context, r.traceInfo(1000));
    r.commands.run();
    const TreeHeader h = r.header();
    EXPECT_EQ(h.status, TreeHeader::kShortOfCapacity);
    EXPECT_GT(h.wanted.nodes, 50u);
    EXPECT_EQ(h.wanted.refs, 0u);
    EXPECT_GT(h.wantedBytes, h.bytes);
    expectBruteForce(makeTriangleSet(world), rays, r.hits.download<Hit>(rays.size()));
}

// Two trees over the even and the odd triangles, the second traced from the hits of the first: the answers of one tree
// over all. Triangles come in pairs in one place, so that ties across trees go to the lower number.
TEST(Record, GoesOnFromTheHitsOfAnotherTree) {
    std::vector<Triangle> world = mixedTriangles(600, 8);
    for (size_t i = 0; i + 1 < world.size(); i += 6) world[i + 1] = world[i];
    std::vector<uint32_t> even, odd;
    for (uint32_t i = 0; i < world.size(); i++) (i % 2 == 0 ? even : odd).push_back(i);
    const std::vector<Ray> rays = mixedRays(3000, 8);
    const DeviceTriangles triangles(device(), world);
    GpuBuilder builder(device());
    const auto first = builder.build(triangles, BuildSettings{}, even).tree;
    const auto second = builder.build(triangles, BuildSettings{}, odd).tree;
    EXPECT_EQ(treeHash(readBack(*first)), treeHash(buildTwin(makeTriangleSet(world, even), BuildSettings{}).tree));
    Tracer tracer(device());
    for (const bool evenFirst : {true, false}) {
        const DeviceTree& a = evenFirst ? *first : *second;
        const DeviceTree& b = evenFirst ? *second : *first;
        const std::vector<Hit> some = tracer.trace(a, rays).hits;
        expectBruteForce(makeTriangleSet(world), rays, tracer.trace(b, rays, {}, some).hits);
        const std::vector<Hit> any = tracer.trace(b, rays, {.query = Query::any}, some).hits;
        for (size_t i = 0; i < rays.size(); i++) {
            if (some[i].prim == kNone) continue;
            ASSERT_EQ(std::memcmp(&any[i], &some[i], sizeof(Hit)), 0) << "a hit that is given ends the ray";
        }
    }
}

// Tiny batches and tiny step limits: many dispatches, the same answers.
TEST(Record, AnswersAlikeInManyDispatches) {
    const std::vector<Triangle> world = mixedTriangles(2000, 2);
    const TriangleSet set = makeTriangleSet(world);
    const std::vector<Ray> rays = mixedRays(2500, 2);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const Tracer::Result want = Tracer(device()).trace(*tree, rays);
    for (const Traversal traversal : {Traversal::restart, Traversal::shortStack}) {
        SCOPED_TRACE(traversal == Traversal::restart ? "restart" : "short stack");
        const TraceMode mode{.traversal = traversal};
        Tracer small(device(), {.batch = 64, .stepLimit = 7, .mostDispatches = 1u << 20});
        const Tracer::Result got = small.trace(*tree, rays, mode);
        EXPECT_EQ(std::memcmp(got.hits.data(), want.hits.data(), want.hits.size() * sizeof(Hit)), 0);
        EXPECT_EQ(got.invalidRays, want.invalidRays);
        EXPECT_EQ(got.cappedRays, 0u);
        // Given up too soon: counted, and answered by no more than what was found.
        const Tracer::Result capped = Tracer(device(), {.stepLimit = 7, .mostDispatches = 2}).trace(*tree, rays, mode);
        EXPECT_GT(capped.cappedRays, 0u);
    }
}

// Rows of three workgroups: every kernel takes its share of a dispatch that is laid out in rows.
TEST(Record, BuildsAndTracesInShortRows) {
    DeviceOptions options;
    options.longestRow = 3;
    const std::unique_ptr<Device> rows = openTestDevice(options);
    const std::vector<Triangle> world = mixedTriangles(5000, 1);
    const std::vector<Ray> rays = mixedRays(2000, 1);
    GpuBuilder builder(*rows), usual(device());
    const auto tree = builder.build(DeviceTriangles(*rows, world), BuildSettings{}).tree;
    EXPECT_EQ(treeHash(readBack(*tree)),
              treeHash(readBack(*usual.build(DeviceTriangles(device(), world), BuildSettings{}).tree)));
    expectBruteForce(makeTriangleSet(world), rays, Tracer(*rows).trace(*tree, rays).hits);
}

// The same for every kernel of a picture.
TEST(Record, RendersInShortRows) {
    DeviceOptions options;
    options.longestRow = 3;
    const std::unique_ptr<Device> rows = openTestDevice(options);
    SmallPicture small = smallPicture(500, 3);
    small.request.samples = 2;
    const TriangleSet set = makeTriangleSet(small.world);
    const KdTree tree = buildExact(set, BuildSettings{});
    const auto pixels = [&](Device& on, View view) {
        small.request.view = view;
        Tracer tracer(on);
        Renderer renderer(on, tracer);
        return renderer
            .render(*uploadTree(on, set, tree), DeviceTriangles(on, small.world), DeviceSurfaces(on, small.data),
                    small.request)
            .pixels;
    };
    for (const View view : {View::shaded, View::normals, View::depth, View::steps, View::leaves, View::path}) {
        SCOPED_TRACE(static_cast<int>(view));
        EXPECT_EQ(pixels(*rows, view), pixels(device(), view));
    }
}

// The textbook's test in float, which only shows how others fare: against a plain loop of the same. Division is not
// exactly rounded everywhere, so t may differ in its last places; that it is another test than ours shows in t, too.
TEST(Record, TracesByThePlainTest) {
    const TriangleSet set = makeTriangleSet(mixedTriangles(500, 4));
    const std::vector<Ray> rays = mixedRays(3000, 4);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const auto looped = [&](const Ray& ray) {
        Hit best = missedHit();
        if (!isValidRay(ray)) return best;
        const ScaledRay s = scaledRay(ray, set.exponent);
        for (const uint32_t i : set.included) {
            const Triangle& t = set.triangles[i];
            Hit h = plainTriangle(s.origin, s.direction, t.a, t.b, t.c);
            h.prim = i;
            if (isFinite(h.t) && h.t >= s.tMin && h.t <= s.tMax && isCloser(h, best)) best = h;
        }
        return worldHit(best, s.tExponent);
    };
    Tracer tracer(device());
    const std::vector<Hit> ours = tracer.trace(*tree, rays).hits;
    for (const Traversal traversal : {Traversal::restart, Traversal::stack, Traversal::shortStack}) {
        SCOPED_TRACE(static_cast<int>(traversal));
        const TraceMode mode{.traversal = traversal, .test = TriangleTest::plain};
        const std::vector<Hit> plain = tracer.trace(*tree, rays, mode).hits;
        uint32_t hits = 0, others = 0, bits = 0;
        for (size_t i = 0; i < rays.size(); i++) {
            const Hit want = looped(rays[i]);
            hits += want.prim != kNone;
            bits += plain[i].prim != kNone && plain[i].t != ours[i].t;
            const bool isSame = plain[i].prim == want.prim &&
                                (want.prim == kNone || std::fabs(plain[i].t - want.t) <= 1e-6f * std::fabs(want.t));
            others += isSame ? 0 : 1;
        }
        EXPECT_GT(hits, 200u);
        EXPECT_GT(bits, 100u);
        EXPECT_LE(others, rays.size() / 500);
    }
}

std::string complaintOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// A device without room says so, and goes on.
TEST(Record, SaysWhenTheDeviceIsOutOfMemory) {
    DeviceOptions options;
    options.largestAllocation = 1 << 20;
    const std::unique_ptr<Device> tiny = openTestDevice(options);
    const std::vector<Triangle> large = mixedTriangles(40000, 6), few = mixedTriangles(20, 6);
    const std::string atMost = "the device gives at most 2 MiB in one piece";
    GpuBuilder builder(*tiny);
    Tracer tracer(*tiny);
    EXPECT_NE(complaintOf([&] { builder.build(DeviceTriangles(*tiny, large), BuildSettings{}); }).find(atMost),
              std::string::npos);
    const TriangleSet set = makeTriangleSet(few);
    const auto tree = uploadTree(*tiny, set, buildExact(set, BuildSettings{}));
    EXPECT_NE(complaintOf([&] { tracer.trace(*tree, mixedRays(40000, 6)); }).find(atMost), std::string::npos);
    const std::vector<Ray> rays = mixedRays(500, 6);
    expectBruteForce(set, rays, tracer.trace(*tree, rays).hits);
    for (const VkResult result : {VK_ERROR_OUT_OF_DEVICE_MEMORY, VK_ERROR_OUT_OF_HOST_MEMORY})
        EXPECT_EQ(complaintOf([&] { check(result, "creating a buffer"); }),
                  "creating a buffer: the device is out of memory; set a memory budget or use a smaller scene");
}

// As on a discrete GPU with resizable BAR: writes are direct; what is read goes through the ring if it is much.
TEST(Record, WorksWithMemoryThatTheHostDoesNotCache) {
    DeviceOptions options;
    options.hostCaches = false;
    options.stagingBytes = 4096;
    const std::unique_ptr<Device> uncached = openTestDevice(options);
    std::vector<uint32_t> written(5000);
    std::iota(written.begin(), written.end(), 7u);
    Buffer buffer = uploaded(*uncached, std::span<const uint32_t>(written));
    EXPECT_EQ(buffer.download<uint32_t>(written.size()), written);
    written[4000] = 1;
    buffer.write(4000 * sizeof(uint32_t), &written[4000], sizeof(uint32_t));
    EXPECT_EQ(buffer.download<uint32_t>(written.size()), written);
    uint32_t few[2];
    buffer.read(3999 * sizeof(uint32_t), few, sizeof(few));
    EXPECT_EQ(few[0], written[3999]);
    EXPECT_EQ(few[1], 1u);
}

// As on a discrete GPU: no memory is mapped, and a small ring moves everything. Buffers are limited, too, so that
// scratch memory comes in several.
TEST(Record, WorksWithoutMappedMemory) {
    DeviceOptions options;
    options.maps = false;
    options.stagingBytes = 4096;
    options.largestAllocation = 2 << 20;
    const std::unique_ptr<Device> discrete = openTestDevice(options);
    const std::vector<Triangle> world = mixedTriangles(3000, 7);
    const std::vector<Ray> rays = mixedRays(2000, 7);
    BuildInfo info;
    const DeviceTriangles triangles(*discrete, world);
    const Geometry geometry = triangles.geometry();
    info.geometries = &geometry;
    info.geometryCount = 1;
    info.largestRange = discrete->largestAllocation();
    EXPECT_GT(buildSizes(info).scratchCount, 1u);
    GpuBuilder builder(*discrete), usual(device());
    const auto tree = builder.build(triangles, BuildSettings{}).tree;
    EXPECT_EQ(treeHash(readBack(*tree)),
              treeHash(readBack(*usual.build(DeviceTriangles(device(), world), BuildSettings{}).tree)));
    expectBruteForce(makeTriangleSet(world), rays, Tracer(*discrete).trace(*tree, rays).hits);
    EXPECT_THROW(Buffer(*discrete, (2 << 20) + 1), Error);
}

uint64_t residentBytes() {
    uint64_t pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return resident * 4096;
}

// Builds and traces one after the other leave nothing behind, on the device or on the host. CLEAVE_LONG=1: a thousand.
TEST(Record, MemoryDoesNotGrow) {
    const char* isLong = std::getenv("CLEAVE_LONG");
    const int runs = isLong != nullptr && *isLong == '1' ? 1000 : 60;
    const std::vector<Triangle> world = mixedTriangles(400, 17);
    const std::vector<Ray> rays = mixedRays(500, 17);
    GpuBuilder builder(device());
    Tracer tracer(device());
    uint64_t onDevice = 0, onHost = 0;
    for (int run = 0; run < runs; run++) {
        const DeviceTriangles triangles(device(), world);
        const auto tree = builder.build(triangles, BuildSettings{}).tree;
        ASSERT_EQ(tracer.trace(*tree, rays).cappedRays, 0u);
        if (run == 20) {
            onDevice = device().memoryInUse();
            onHost = residentBytes();
        }
    }
    const DeviceTriangles triangles(device(), world);
    const auto tree = builder.build(triangles, BuildSettings{}).tree;
    EXPECT_LE(device().memoryInUse(), onDevice + triangles.triangles.size() + tree->memory.size());
    EXPECT_LE(residentBytes(), onHost + (uint64_t{16} << 20)) << "validation layers keep some";
    std::printf("%d builds: %.1f MiB on the device, host grew by %.1f MiB\n", runs,
                static_cast<double>(device().memoryInUse()) / (1 << 20),
                (static_cast<double>(residentBytes()) - static_cast<double>(onHost)) / (1 << 20));
}

// A picture that is taken in slices is the picture, in every view, sample by sample.
TEST(Record, PicturesAreTheSameInSlices) {
    SmallPicture small = smallPicture(2000, 12);
    PictureRequest& request = small.request;
    const DeviceTriangles triangles(device(), small.world);
    const auto tree =
        uploadTree(device(), makeTriangleSet(small.world), buildExact(makeTriangleSet(small.world), BuildSettings{}));
    const DeviceSurfaces opaque(device(), small.data), seenThrough(device(), blended(small.data));
    Tracer tracer(device());
    const size_t strip = size_t{8} * request.camera.width;
    Renderer whole(device(), tracer), sliced(device(), tracer, {.batch = 2 * strip + 1});
    for (const DeviceSurfaces* surfaces : {&opaque, &seenThrough})
        for (const View view : {View::shaded, View::path, View::normals, View::depth, View::steps, View::leaves}) {
            request.view = view;
            request.samples = takesSamples(view) ? 3 : 1;
            const Picture want = whole.render(*tree, triangles, *surfaces, request);
            sliced.begin(*tree, triangles, *surfaces, request);
            uint32_t slices = 0;
            while (sliced.samplesTaken() < request.samples) {
                slices++;
                if (sliced.takeSlice()) continue;
                EXPECT_EQ(sliced.rowsTaken() % 16, 0u);
                if (sliced.samplesTaken() == 0 && request.samples == 1) {
                    const Picture part = sliced.show();
                    const auto rows = static_cast<ptrdiff_t>(size_t{sliced.rowsTaken()} * part.width);
                    EXPECT_TRUE(std::equal(part.pixels.begin(), part.pixels.begin() + rows, want.pixels.begin()));
                }
            }
            EXPECT_EQ(slices, hasScale(view) ? 1 : request.samples * ((request.camera.height + 15) / 16));
            const Picture got = sliced.show();
            EXPECT_EQ(got.pixels, want.pixels);
            EXPECT_EQ(got.samples, want.samples);
            EXPECT_EQ(got.scaleHigh, want.scaleHigh);
        }
}

// A picture whose rays take many dispatches is the picture.
TEST(Record, PicturesGoOnWhereTheStepLimitEndedThem) {
    SmallPicture small = smallPicture(2000, 12);
    PictureRequest& request = small.request;
    const TriangleSet set = makeTriangleSet(small.world);
    const DeviceTriangles triangles(device(), small.world);
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const DeviceSurfaces surfaces(device(), small.data);
    Tracer tracer(device());
    Renderer usual(device(), tracer), limited(device(), tracer, {.stepLimit = 9});
    for (const View view : {View::shaded, View::depth, View::normals}) {
        request.view = view;
        request.samples = view == View::shaded ? 2 : 1;
        const Picture want = usual.render(*tree, triangles, surfaces, request);
        const Picture got = limited.render(*tree, triangles, surfaces, request);
        EXPECT_EQ(got.pixels, want.pixels);
        EXPECT_EQ(got.cappedRays, 0u);
        EXPECT_EQ(got.scaleHigh, want.scaleHigh);
    }
    // Hits are tile by tile, and those of their rays.
    request.view = View::normals;
    usual.render(*tree, triangles, surfaces, request);
    expectBruteForce(set, usual.readRays(), usual.readHits());
}

}  // namespace cleave::test
