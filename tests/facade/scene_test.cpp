// cleave/scene.hpp from outside: every builder, lists, budgets, adopted devices, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "cleave/scene.hpp"
#include "gpu/device.h"

namespace cleave::scene {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class SceneTest : public testing::Test {
  protected:
    SceneTest() {
        std::mt19937 random(7);
        const auto unit = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
        triangles_.resize(600);
        for (Triangle& t : triangles_)
            for (size_t axis = 0; axis < 3; axis++) {
                t[axis] = unit();
                t[3 + axis] = t[axis] + 0.2f * unit();
                t[6 + axis] = t[axis] - 0.2f * unit();
            }
        rays_.resize(300);
        for (TraceRay& r : rays_) {
            r = {{3.0f * unit() - 1.0f, 3.0f * unit() - 1.0f, 2.0f}, 0.0f, {}, kInfinity};
            for (int axis = 0; axis < 3; axis++) r.direction[axis] = unit() - r.origin[axis];
        }
    }
    ~SceneTest() override { EXPECT_EQ(messages_, 0) << "validation"; }

    DeviceOptions options() {
        DeviceOptions o;
        o.onValidation = [this](const char* message) {
            std::fprintf(stderr, "%s\n", message);
            messages_++;
        };
        return o;
    }

    int messages_ = 0;
    std::vector<Triangle> triangles_;
    std::vector<TraceRay> rays_;
};

void expectSame(std::span<const TraceHit> a, std::span<const TraceHit> b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); i++) {
        EXPECT_EQ(a[i].prim, b[i].prim) << i;
        EXPECT_EQ(a[i].t, b[i].t) << i;
    }
}

std::string failure(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST_F(SceneTest, EveryBuilderGivesTheReferencesAnswers) {
    Device device(options());
    Mesh mesh(device, triangles_);
    for (const std::string_view builder : builders()) {
        SCOPED_TRACE(builder);
        const Tree tree = mesh.build(builder);
        EXPECT_EQ(tree.counts().triangles, triangles_.size());
        EXPECT_GE(tree.counts().references, triangles_.size());
        EXPECT_EQ(tree.counts().nodes > 1, builder != "brute");
        EXPECT_GT(tree.counts().bytes, triangles_.size() * sizeof(Triangle));
        for (const Query query : {Query::closest, Query::any}) {
            TraceMode mode;
            mode.query = query;
            const Answers answers = tree.trace(rays_, mode);
            const Judgement judged = mesh.judge(rays_, answers.hits, query, rays_.size());
            EXPECT_EQ(judged.rays, rays_.size());
            EXPECT_EQ(judged.mismatches, 0u) << judged.firstMismatch;
            EXPECT_EQ(answers.unfinishedRays, 0u);
        }
    }
}

TEST_F(SceneTest, WrongHitsAreMismatches) {
    Device device(options());
    Mesh mesh(device, triangles_);
    std::vector<TraceHit> hits = mesh.build().trace(rays_).hits;
    size_t i = 0;
    while (!std::isfinite(hits[i].t)) i++;
    hits[i].t *= 1.01f;
    const Judgement judged = mesh.judge(rays_, hits, Query::closest, rays_.size());
    EXPECT_EQ(judged.mismatches, 1u);
    EXPECT_NE(judged.firstMismatch, "");
}

TEST_F(SceneTest, TwoTreesOverListsAnswerLikeOneOverAll) {
    Device device(options());
    Mesh mesh(device, triangles_);
    std::vector<uint32_t> lists[2];
    for (uint32_t i = 0; i < triangles_.size(); i++) lists[i % 3 == 0].push_back(i);
    const std::vector<TraceHit> whole = mesh.build().trace(rays_).hits;
    for (const std::string_view builder : {"gpu", "exact"}) {
        SCOPED_TRACE(builder);
        const Tree first = mesh.build(builder, {}, lists[0]);
        EXPECT_EQ(first.counts().triangles, lists[0].size());
        const std::vector<TraceHit> hits = first.trace(rays_).hits;
        for (const TraceHit& hit : hits) EXPECT_TRUE(!std::isfinite(hit.t) || hit.prim % 3 != 0);
        expectSame(mesh.build(builder, {}, lists[1]).trace(rays_, {}, hits).hits, whole);
    }
}

TEST_F(SceneTest, ABudgetLimitsTheTreeButNotTheAnswers) {
    Device device(options());
    Mesh mesh(device, triangles_);
    const Tree full = mesh.build();
    BuildSettings settings;
    settings.memory = full.counts().peakBytes / 4;
    const Tree limited = mesh.build("gpu", settings);
    EXPECT_FALSE(full.counts().memoryLimited);
    EXPECT_TRUE(limited.counts().memoryLimited);
    EXPECT_LT(limited.counts().nodes, full.counts().nodes);
    expectSame(limited.trace(rays_).hits, full.trace(rays_).hits);
}

TEST_F(SceneTest, WhatCannotBeBuiltOverIsCounted) {
    triangles_[1][4] = std::numeric_limits<float>::quiet_NaN();
    triangles_[2] = {};
    Device device(options());
    Mesh mesh(device, triangles_);
    for (const std::string_view builder : {"gpu", "gpu-exact", "twin", "exact"}) {
        const TreeCounts counts = mesh.build(builder).counts();
        EXPECT_EQ(counts.nonFinite, 1u) << builder;
        EXPECT_EQ(counts.noArea, 1u) << builder;
    }
}

TEST_F(SceneTest, AnAdoptedDeviceAnswersLikeOneThatIsOpened) {
    Device opened(options());
    const std::vector<TraceHit> hits = Mesh(opened, triangles_).build().trace(rays_).hits;
    const cleave::Device owner{cleave::DeviceOptions{}};
    const AdoptedDevice handles{owner.instance(), owner.physicalDevice(), owner.handle(), owner.queue(), 0};
    Device adopted(handles);
    EXPECT_EQ(adopted.name(), opened.name());
    expectSame(Mesh(adopted, triangles_).build().trace(rays_).hits, hits);
}

TEST_F(SceneTest, PipelinesAndTransfersGoWhereTheOptionsSay) {
    DeviceOptions o = options();
    std::string loaded, stored;
    o.mapsMemory = false;
    o.loadPipelines = [&](const std::string& key) { return loaded = key, std::vector<char>(100, 'x'); };
    o.storePipelines = [&](const std::string& key, std::span<const char> data) { stored = data.empty() ? "" : key; };
    {
        Device device(o);
        Mesh mesh(device, triangles_);
        const Tree tree = mesh.build("exact");
        const uint64_t before = device.transfers().down;
        tree.trace(rays_);
        EXPECT_GE(device.transfers().down, before + rays_.size() * sizeof(TraceHit));
        EXPECT_GE(device.transfers().up, rays_.size() * sizeof(TraceRay) + tree.counts().bytes / 2);
    }
    EXPECT_NE(stored, "");
    EXPECT_EQ(stored, loaded);
}

TEST_F(SceneTest, MistakesAreRefusedInSentences) {
    Device device(options());
    Mesh mesh(device, triangles_);
    const Tree tree = mesh.build("brute");
    const std::vector<TraceHit> hits(rays_.size() - 1);
    const std::vector<uint32_t> twice{3, 3}, beyond{3, 600};
    BuildSettings bins, exactUpTo, maxDepth, memory, costLeaf, emptyBonus, noBonus;
    bins.bins = 33;
    exactUpTo.exactUpTo = 1025;
    maxDepth.maxDepth = 64;
    memory.memory = 1;
    costLeaf.costLeaf = -1.0f;
    emptyBonus.emptyBonus = 1.5f;
    noBonus.emptyBonus = NAN;
    EXPECT_NE(failure([&] { mesh.build("best"); }).find("gpu, gpu-exact, twin, exact"), std::string::npos);
    EXPECT_NE(failure([&] { mesh.build("gpu", {}, twice); }), "");
    EXPECT_NE(failure([&] { mesh.build("exact", {}, beyond); }), "");
    for (const BuildSettings& settings : {bins, exactUpTo, maxDepth, memory, costLeaf, emptyBonus, noBonus})
        EXPECT_NE(failure([&] { mesh.build("gpu", settings); }), "");
    EXPECT_NE(failure([&] { tree.trace(rays_, {}, hits); }), "");
    EXPECT_NE(failure([&] { mesh.judge(rays_, hits, Query::closest, 1); }), "");
    DeviceOptions o = options();
    o.nameOrIndex = "no such device";
    EXPECT_NE(failure([&] { Device none(o); }), "");
    EXPECT_NE(failure([&] { GltfFile("no/such.glb"); }), "");
}

// A cube of 12 triangles about the middle of the unit cube.
std::vector<Triangle> cube() {
    std::vector<Triangle> triangles;
    const auto corner = [](int bits) {
        return Point{bits & 1 ? 0.75f : 0.25f, bits & 2 ? 0.75f : 0.25f, bits & 4 ? 0.75f : 0.25f};
    };
    const auto add = [&](int a, int b, int c) {
        Triangle t{};
        for (const int bits : {a, b, c}) {
            const Point p = corner(bits);
            std::copy(p.begin(), p.end(), t.begin() + 3 * (bits == a ? 0 : bits == b ? 1 : 2));
        }
        triangles.push_back(t);
    };
    for (const auto& face :
         {std::array{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
        add(face[0], face[1], face[2]);
        add(face[0], face[2], face[3]);
    }
    return triangles;
}

// Anywhere about the unit cube, and on the cube.
std::vector<Point> somePoints() {
    std::mt19937 random(3);
    const auto unit = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    std::vector<Point> points{{0.25f, 0.5f, 0.5f}, {0.75f, 0.75f, 0.5f}, {0.25f, 0.25f, 0.25f}};
    for (int i = 0; i < 300; i++) points.push_back({1.5f * unit() - 0.25f, 1.5f * unit() - 0.25f, unit()});
    return points;
}

template <class T>
bool areSameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST_F(SceneTest, QueriesOfTreesAreThoseOfTheTwin) {
    Device device(options());
    for (const bool isClosed : {false, true}) {
        Mesh mesh(device, isClosed ? cube() : triangles_);
        const Twin twin = mesh.twin();
        const std::vector<Point> points = somePoints();
        std::vector<Box> boxes;
        for (const Point& p : points) boxes.push_back({p, {p[0] + 0.1f, p[1], p[2] + 0.2f}});
        for (const std::string_view builder : {"gpu", "exact"}) {
            SCOPED_TRACE(builder);
            const Tree tree = mesh.build(builder);
            const AllHits all = tree.all(rays_, 5);
            EXPECT_EQ(all.hits.size(), 5 * rays_.size());
            EXPECT_TRUE(areSameBytes(all.hits, twin.all(rays_, 5).hits));
            for (const bool isSigned : {false, true})
                EXPECT_EQ(tree.count(rays_, isSigned).counts, twin.count(rays_, isSigned).counts);
            for (const float within : {0.01f, kInfinity})
                EXPECT_TRUE(areSameBytes(tree.nearest(points, within).hits, twin.nearest(points, within).hits));
            const Overlaps met = tree.overlaps(boxes);
            EXPECT_GT(met.pairs.size(), 10u);
            EXPECT_TRUE(areSameBytes(met.pairs, twin.overlaps(boxes).pairs));
            if (!isClosed) continue;
            EXPECT_EQ(tree.contains(points).isInside, twin.contains(points).isInside);
            EXPECT_EQ(tree.signedDistance(points).distances, twin.signedDistance(points).distances);
        }
    }
}

TEST_F(SceneTest, DistancesAreNegativeInside) {
    Device device(options());
    Mesh mesh(device, cube());
    const std::vector<Point> points = somePoints();
    const std::vector<float> distances = mesh.build().signedDistance(points).distances;
    int inside = 0;
    for (size_t i = 0; i < points.size(); i++) {
        float most = -1.0f, square = 0.0f;
        for (const float x : points[i]) {
            const float beyond = std::fabs(x - 0.5f) - 0.25f;
            most = std::max(most, beyond);
            square += beyond > 0.0f ? beyond * beyond : 0.0f;
        }
        EXPECT_NEAR(distances[i], most > 0.0f ? std::sqrt(square) : most, 1e-6f) << i;
        inside += distances[i] < 0.0f;
    }
    EXPECT_GT(inside, 10);
    EXPECT_EQ(distances[0], 0.0f);
    EXPECT_FALSE(std::signbit(distances[0])) << "on the surface";
}

TEST_F(SceneTest, QueriesRefuseWhatTheyCannotAnswer) {
    Device device(options());
    std::vector<Triangle> open = cube();
    open.pop_back();
    Mesh mesh(device, open), closed(device, cube());
    const Tree tree = mesh.build(), whole = closed.build();
    const Twin twin = mesh.twin();
    std::vector<Point> points = somePoints();
    try {
        tree.contains(points);
        FAIL() << "nothing was thrown";
    } catch (const NotClosed& error) {
        EXPECT_EQ(error.openEdges, 3u);
        EXPECT_NE(std::string(error.what()).find("3 edges"), std::string::npos);
    }
    EXPECT_THROW(tree.signedDistance(points), NotClosed);
    EXPECT_THROW(twin.contains(points), NotClosed);
    const std::vector<uint32_t> most{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    EXPECT_THROW(closed.build("gpu", {}, most).contains(points), NotClosed);
    points[7][1] = NAN;
    points[9][0] = kInfinity;
    const auto row = [](const std::function<void()>& call) {
        try {
            call();
        } catch (const BadItem& error) {
            return static_cast<int>(error.row);
        }
        return -1;
    };
    EXPECT_EQ(row([&] { whole.nearest(points); }), 7);
    EXPECT_EQ(row([&] { whole.contains(points); }), 7);
    EXPECT_EQ(row([&] { whole.signedDistance(points); }), 7);
    EXPECT_EQ(row([&] { twin.nearest(points); }), 7);
    std::vector<Box> boxes(3, Box{{0, 0, 0}, {1, 1, 1}});
    boxes[2].lo[2] = 2.0f;
    EXPECT_EQ(row([&] { whole.overlaps(boxes); }), 2);
    boxes[1].hi[0] = NAN;
    EXPECT_EQ(row([&] { whole.overlaps(boxes); }), 1);
    EXPECT_NE(failure([&] { tree.all(rays_, 0); }), "");
    EXPECT_NE(failure([&] { tree.all(rays_, (1u << 20) + 1); }), "");
    EXPECT_NE(failure([&] { tree.nearest({}, -1.0f); }), "");
    EXPECT_NE(failure([&] { tree.nearest({}, NAN); }), "");
    TraceMode counting;
    counting.query = Query::count;
    EXPECT_NE(failure([&] { tree.trace(rays_, counting); }), "");
    EXPECT_EQ(tree.all({}, 3).hits.size() + whole.contains({}).isInside.size(), 0u);
}

TEST_F(SceneTest, ASavedTreeAnswersAsTheOneThatWasSaved) {
    Device device(options());
    Mesh mesh(device, triangles_), other(device, cube());
    for (const std::string_view builder : {"gpu", "exact", "brute"}) {
        const Tree tree = mesh.build(builder);
        std::vector<std::byte> saved = tree.save();
        const Tree loaded = mesh.load(saved);
        EXPECT_EQ(loaded.counts().nodes, tree.counts().nodes);
        EXPECT_EQ(loaded.counts().triangles, tree.counts().triangles);
        EXPECT_TRUE(areSameBytes(loaded.trace(rays_).hits, tree.trace(rays_).hits));
        EXPECT_EQ(loaded.save(), saved);
        EXPECT_NE(failure([&] { other.load(saved); }).find("other triangles"), std::string::npos);
        saved.pop_back();
        EXPECT_NE(failure([&] { mesh.load(saved); }), "");
    }
    const std::vector<uint32_t> list{1, 2};
    EXPECT_NE(failure([&] { mesh.build("gpu", {}, list).save(); }), "");
    Mesh empty(device, {});
    EXPECT_EQ(empty.load(empty.build().save()).counts().references, 0u);
}

TEST_F(SceneTest, AFileIsLoadedAndPosed) {
    const GltfFile file(std::string(CLEAVE_SOURCE) + "/scenes/cornell.glb");
    const Posed posed = file.pose();
    Device device(options());
    Mesh mesh(device, posed.triangles);
    EXPECT_EQ(mesh.build().counts().triangles, posed.triangles.size());
    EXPECT_GT(posed.triangles.size(), 10u);
}

TEST_F(SceneTest, OneUsableDeviceIsChosen) {
    int chosen = 0;
    for (const DeviceInfo& info : listDevices()) {
        chosen += info.chosen;
        EXPECT_TRUE(!info.chosen || info.lacks.empty());
    }
    EXPECT_EQ(chosen, 1);
}

}  // namespace
}  // namespace cleave::scene
