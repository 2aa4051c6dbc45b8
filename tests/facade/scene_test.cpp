// cleave/scene.hpp from outside: every builder, lists, budgets, adopted devices, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
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
    settings.memory = full.counts().peakBytes / 3;
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
    for (const std::string_view builder : {"gpu", "twin", "exact"}) {
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
    EXPECT_NE(failure([&] { mesh.build("best"); }).find("gpu, twin, exact"), std::string::npos);
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
