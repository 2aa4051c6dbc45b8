// The GPU builder as a whole: the same tree as its twin, in every run, and a valid one.
#include <gtest/gtest.h>

#include "builders/builders.h"
#include "judge/validate.h"
#include "run/gpu_builder.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scene_files.h"
#include "support/scenes.h"
#include "twin/passes.h"
#include "twin/twin_builder.h"

namespace cleave::test {

namespace {

// A builder remembers how much room builds took: what depends on that asks for one of its own.
GpuBuilder::Result expectTwinsTree(const std::vector<Triangle>& world, const BuildSettings& settings,
                                   GpuBuilder& builder = sharedBuilder()) {
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(device(), world);
    const GpuBuilder::Result first = builder.build(triangles, settings);
    const GpuBuilder::Result second = builder.build(triangles, settings);
    const BuildOutcome twin = buildTwin(set, settings);
    const KdTree tree = readBack(*first.tree);
    EXPECT_EQ(treeHash(tree), treeHash(readBack(*second.tree))) << "two runs differ";
    EXPECT_EQ(first.memoryLimited, twin.memoryLimited);
    EXPECT_EQ(treeHash(tree), treeHash(twin.tree));
    const ValidationReport report = validate(tree, set, depthLimit(settings, set.included.size()));
    EXPECT_TRUE(report.ok()) << report.errors.front();
    return first;
}

}  // namespace

// A timed build is the same build: every kernel shows, and its levels hold the tree's nodes.
TEST(GpuBuilder, ProfilesEveryKernel) {
    const std::vector<Triangle> world = mixedTriangles(3000, 5);
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(device(), world);
    GpuBuilder builder(device());
    builder.build(triangles, BuildSettings{});
    const BuildProfile profile = builder.profile(triangles, BuildSettings{});
    std::vector<std::string> names, wanted{"arguments"};
    for (const PassWork& pass : profile.passes) names.push_back(pass.name);
    for (const auto& table : {twin::setupPasses(), twin::levelPasses(), twin::lastPasses()})
        for (const twin::Pass& pass : table)
            if (pass.row.runs(PassChoice{}) && std::find(wanted.begin(), wanted.end(), pass.row.kernel) == wanted.end())
                wanted.push_back(pass.row.kernel);
    EXPECT_EQ(names, wanted);
    const KdTree twin = buildTwin(set, BuildSettings{}).tree;
    EXPECT_EQ(treeHash(readBack(*builder.build(triangles, BuildSettings{}).tree)), treeHash(twin));
    uint64_t nodes = 0, references = 0, classified = 0;
    for (const LevelWork& level : profile.levels) nodes += level.nodes;
    for (const LevelWork& level : profile.levels) references += level.references;
    for (const PassWork& pass : profile.passes)
        if (pass.name == "classify") classified = pass.elements;
    EXPECT_GT(nodes, 0u);
    EXPECT_LT(nodes, twin.nodes.size());  // the others are within subtrees
    EXPECT_EQ(profile.nodes, twin.nodes.size());
    EXPECT_EQ(classified, references);
    EXPECT_EQ(profile.levels.at(0).references, set.included.size());
}

TEST(GpuBuilder, EqualsTwinOnMadeScenes) {
    for (uint32_t n : kSizes) {
        SCOPED_TRACE("triangles " + std::to_string(n));
        BuildSettings settings;
        expectTwinsTree(mixedTriangles(n, n + 5), settings);
        settings.clip = false;
        settings.bins = 7;
        settings.exactUpTo = 3;
        settings.maxDepth = 9;
        expectTwinsTree(mixedTriangles(n, n + 6), settings);
    }
}

// What the heuristic counts with and what moves its planes, one after the other and all together.
std::vector<BuildSettings> rulesOfTheHeuristic() {
    std::vector<BuildSettings> rules(5);
    rules[0].snap = false;
    rules[1].costs.leaf = 7.5f;
    rules[2].costs.emptyBonus = 1.0f;
    rules[3].stop = StopRule::equation41;
    rules[4] = {.costs = {11.0f, 17.0f, 3.0f, 0.6f}, .exactUpTo = 20, .subsample = false, .snap = false};
    return rules;
}

TEST(GpuBuilder, EqualsTwinUnderEveryRuleOfTheHeuristic) {
    const std::vector<Triangle> world = mixedTriangles(5000, 21);
    std::string before = treeHash(buildTwin(makeTriangleSet(world), BuildSettings{}).tree);
    for (const BuildSettings& settings : rulesOfTheHeuristic()) {
        const std::string hash = treeHash(readBack(*expectTwinsTree(world, settings).tree));
        EXPECT_NE(hash, before) << "the rule changes nothing";
        before = hash;
    }
}

// Up to exactUpTo references the twin goes by the same costs as the exact builder on the CPU.
TEST(GpuBuilder, KeepsTheRulesOfTheExactBuilder) {
    for (const BuildSettings& settings : rulesOfTheHeuristic())
        for (uint32_t seed = 1; seed <= 5; seed++) {
            SCOPED_TRACE(seed);
            const TriangleSet set = mixedSet(20, seed);
            EXPECT_EQ(treeHash(buildTwin(set, settings).tree), treeHash(buildExact(set, settings)));
        }
}

// A root of 4,000 references is binned: its plane is one of the 31 between bins, which span the scene.
TEST(GpuBuilder, WithoutSnappingPlanesAreBoundariesOfBins) {
    const TriangleSet set = mixedSet(4000, 2);
    BuildSettings settings;
    settings.snap = false;
    const KdTree tree = buildTwin(set, settings).tree;
    const int axis = static_cast<int>(nodeAxis(tree.nodes[0]));
    const double lo = set.bounds.lo[axis], width = (double{set.bounds.hi[axis]} - lo) / kBins;
    const double bins = (nodePosition(tree.nodes[0]) - lo) / width;
    EXPECT_NEAR(bins, std::round(bins), 1e-4);
}

// Passes that do nothing are not recorded, and a profile knows.
TEST(GpuBuilder, LeavesOutWhatSnapsWhereNothingDoes) {
    const std::vector<Triangle> world = mixedTriangles(3000, 5);
    const DeviceTriangles triangles(device(), world);
    GpuBuilder builder(device());
    BuildSettings settings;
    settings.snap = false;
    builder.build(triangles, settings);
    const BuildProfile profile = builder.profile(triangles, settings);
    uint64_t nodes = 0;
    for (const LevelWork& level : profile.levels) nodes += level.nodes;
    EXPECT_GT(nodes, 0u);
    EXPECT_LT(nodes, profile.nodes);  // the others are within subtrees
    for (const PassWork& pass : profile.passes) {
        EXPECT_NE(pass.name, "nearest");
        EXPECT_NE(pass.name, "snap");
    }
    EXPECT_EQ(profile.passes.back().name, "finish_tree");
}

TEST(GpuBuilder, EqualsTwinOnSceneFiles) {
    for (const auto& file : sceneFiles(50000)) {
        SCOPED_TRACE(file.string());
        expectTwinsTree(pose(loadGltf(file)).triangles, BuildSettings{});
    }
}

TEST(GpuBuilder, TakesWhatHasNoExtent) {
    const Triangle flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Triangle point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    const Triangle broken{{1, 1, 1}, {NAN, 1, 1}, {2, 1, INFINITY}};
    for (const std::vector<Triangle>& triangles :
         {std::vector<Triangle>(200, flat), std::vector<Triangle>(5, point), std::vector<Triangle>{broken},
          std::vector<Triangle>{flat, broken, point, flat}}) {
        const GpuBuilder::Result result = expectTwinsTree(triangles, BuildSettings{});
        EXPECT_GE(readBack(*result.tree).leafTriangles.size(), makeTriangleSet(triangles).included.size());
    }
}

// Long thin triangles across the whole scene lie in many more cells than the first estimate allows for.
std::vector<Triangle> needles(uint32_t n) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < n; i++) {
        const glm::vec3 a(unit(random), unit(random), 0.0f);
        const glm::vec3 b(unit(random), unit(random), 1.0f);
        triangles.push_back({a, b, b + glm::vec3(1e-3f, 1e-3f, 0.0f)});
    }
    return triangles;
}

TEST(GpuBuilder, BuildsOnceMoreWhereRoomWasShort) {
    GpuBuilder builder(device());
    const GpuBuilder::Result result = expectTwinsTree(needles(2500), BuildSettings{}, builder);
    EXPECT_GT(result.attempts, 1u);
    EXPECT_FALSE(result.memoryLimited);
}

TEST(GpuBuilder, FinishesInLeavesWhereMemoryIsShort) {
    const std::vector<Triangle> world = needles(6000);
    for (const uint64_t bytes : {uint64_t(3) << 20, uint64_t(5) << 20, uint64_t(9) << 20}) {
        SCOPED_TRACE("bytes " + std::to_string(bytes));
        BuildSettings settings;
        settings.memory = bytes;
        GpuBuilder fresh(device());
        const GpuBuilder::Result result = expectTwinsTree(world, settings, fresh);
        EXPECT_TRUE(result.memoryLimited);
        EXPECT_LE(result.peakBytes, bytes + bytes / 4);  // the finished tree lies beside the scratch for a moment
    }
    BuildSettings tooLittle;
    tooLittle.memory = 1000;
    GpuBuilder builder(device());
    EXPECT_THROW(builder.build(DeviceTriangles(device(), world), tooLittle), Error);
}

TEST(GpuBuilder, MovesTreesBetweenHostAndDevice) {
    const TriangleSet set = mixedSet(300, 1);
    const KdTree tree = buildTwin(set, BuildSettings{}).tree;
    const KdTree back = readBack(*uploadTree(device(), set, tree));
    EXPECT_EQ(treeHash(back), treeHash(tree));
    EXPECT_EQ(back.exponent, tree.exponent);
    EXPECT_EQ(back.bounds.lo, tree.bounds.lo);
}

}  // namespace cleave::test
