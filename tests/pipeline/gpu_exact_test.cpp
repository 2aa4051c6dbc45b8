// Exact SAH on the device: the tree of the exact builder on the CPU, which finds its planes by sorting events, not by
// bins, and shares nothing with it but the heuristic.
#include <gtest/gtest.h>

#include "builders/builders.h"
#include "judge/validate.h"
#include "run/gpu_builder.h"
#include "support/device.h"
#include "support/scene_files.h"
#include "support/scenes.h"
#include "twin/twin_builder.h"

namespace cleave::test {

namespace {

BuildSettings exactly(BuildSettings settings = {}) {
    settings.exact = true;
    return settings;
}

std::string hashOnDevice(const std::vector<Triangle>& world, const BuildSettings& settings) {
    static GpuBuilder* const builder = [] {
        static std::unique_ptr<GpuBuilder> made = std::make_unique<GpuBuilder>(device());
        beforeClose([] { made.reset(); });
        return made.get();
    }();
    return treeHash(readBack(*builder->build(DeviceTriangles(device(), world), settings).tree));
}

void expectTreeOfExact(const std::vector<Triangle>& world, const BuildSettings& settings = {}) {
    const TriangleSet set = makeTriangleSet(world);
    const KdTree exact = buildExact(set, settings);
    EXPECT_EQ(treeHash(buildTwin(set, exactly(settings)).tree), treeHash(exact)) << "the twin's";
    EXPECT_EQ(hashOnDevice(world, exactly(settings)), treeHash(exact)) << "the device's";
}

Triangle smallTriangle(glm::vec3 at, float size, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-size, size);
    const auto vertex = [&] { return at + glm::vec3(unit(random), unit(random), unit(random)); };
    const glm::vec3 a = vertex(), b = vertex();
    return {a, b, vertex()};
}

// A teapot in a stadium: nearly all faces are in one bin of each axis, whatever the bins.
std::vector<Triangle> twoScales(uint32_t n, float ratio) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<Triangle> world;
    for (uint32_t i = 0; i < n; i++) {
        const glm::vec3 at(unit(random), unit(random), unit(random));
        world.push_back(
            smallTriangle(i % 10 == 0 ? at : 0.3f + ratio * at, i % 10 == 0 ? 0.05f : 0.02f * ratio, random));
    }
    return world;
}

// Walls of coplanar triangles: many faces at few positions, flat ones among them.
std::vector<Triangle> walls(uint32_t n) {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<Triangle> world;
    for (uint32_t i = 0; i < n; i++) {
        Triangle t = smallTriangle({unit(random), unit(random), unit(random)}, 0.03f, random);
        const int axis = static_cast<int>(i % 3);
        const float wall = static_cast<float>(i % 4) / 4.0f;
        if (i % 8 != 0) t.a[axis] = t.b[axis] = t.c[axis] = wall;
        world.push_back(t);
    }
    return world;
}

// Right triangles on a grid: costs are equal at planes of several axes, and on both sides of the middle.
std::vector<Triangle> grid(int side) {
    std::vector<Triangle> world;
    for (int x = 0; x < side; x++)
        for (int y = 0; y < side; y++)
            for (int z = 0; z < side; z++) {
                const glm::vec3 at(x, y, z);
                world.push_back({at, at + glm::vec3(1, 0, 0), at + glm::vec3(0, 1, 1)});
                world.push_back({at + glm::vec3(1, 1, 1), at + glm::vec3(0, 1, 1), at + glm::vec3(1, 0, 0)});
            }
    return world;
}

// A wall of large triangles in the middle of a box, and small ones on either side. Wherever the wall's own go, the cost
// is the same but for rounding.
std::vector<Triangle> middleWall(uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const glm::vec3 size(1.0f, 0.5f + unit(random), 0.5f + unit(random));
    std::vector<Triangle> world;
    for (const float x : {0.0f, 1.0f})  // so that the box is the same for all
        world.push_back({{x, 0, 0}, {x, size.y, 0}, {x, size.y, size.z}});
    for (uint32_t i = 0; i < 200 + 13 * seed; i++)
        world.push_back({{0.5f, 0.01f * unit(random), 0}, {0.5f, size.y, 0.01f * unit(random)}, {0.5f, 0, size.z}});
    for (uint32_t i = 0; i < 100; i++)
        for (const float x : {0.02f, 0.9f})
            world.push_back(smallTriangle(
                size * glm::vec3(x + 0.04f, 0.1f + 0.8f * unit(random), 0.1f + 0.8f * unit(random)), 0.02f, random));
    return world;
}

}  // namespace

TEST(GpuExact, BuildsTheTreeOfExactAtEverySize) {
    for (const uint32_t n : kSizes) {
        SCOPED_TRACE("triangles " + std::to_string(n));
        expectTreeOfExact(mixedTriangles(n, n + 7));
    }
}

// Where small nodes end is no matter, since both ways to split find the same planes.
TEST(GpuExact, BuildsTheTreeOfExactHoweverLargeSmallNodesAre) {
    const std::vector<Triangle> world = mixedTriangles(3000, 11);
    for (const uint32_t upTo : {0u, 1u, 20u, 32u, 1024u}) {
        SCOPED_TRACE("exact up to " + std::to_string(upTo));
        BuildSettings settings;
        settings.exactUpTo = upTo;
        expectTreeOfExact(world, settings);
    }
}

TEST(GpuExact, KeepsTheRulesOfTheExactBuilder) {
    std::vector<BuildSettings> rules(6);
    rules[0].costs.leaf = 7.5f;
    rules[1].costs.emptyBonus = 1.0f;
    rules[2].stop = StopRule::equation41;
    rules[3].clip = false;
    rules[4].maxDepth = 7;
    rules[5].costs = {11.0f, 17.0f, 3.0f, 0.2f};
    const std::vector<Triangle> world = mixedTriangles(4000, 3);
    for (size_t i = 0; i < rules.size(); i++) {
        SCOPED_TRACE("rule " + std::to_string(i));
        rules[i].exactUpTo = 40;
        expectTreeOfExact(world, rules[i]);
    }
}

// What binning has, this has not.
TEST(GpuExact, HasNoUseForSettingsOfBins) {
    const std::vector<Triangle> world = mixedTriangles(3000, 12);
    BuildSettings settings;
    settings.bins = 7;
    settings.snap = settings.subsample = false;
    expectTreeOfExact(world, settings);
}

TEST(GpuExact, FindsPlanesWhereFacesCrowd) {
    for (const uint32_t upTo : {10u, kExactUpTo}) {
        SCOPED_TRACE("exact up to " + std::to_string(upTo));
        BuildSettings settings;
        settings.exactUpTo = upTo;
        expectTreeOfExact(twoScales(4000, 1e-3f), settings);
        expectTreeOfExact(twoScales(4000, 1e-6f), settings);
        expectTreeOfExact(walls(5000), settings);
        expectTreeOfExact(grid(12), settings);
        expectTreeOfExact(std::vector<Triangle>(700, {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}), settings);
        expectTreeOfExact(std::vector<Triangle>(700, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), settings);
    }
}

TEST(GpuExact, TakesAWallAsAWhole) {
    for (uint32_t seed = 1; seed <= 30; seed++) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::vector<Triangle> world = middleWall(seed);
        const KdTree tree = buildExact(makeTriangleSet(world), {});
        EXPECT_TRUE(std::ranges::any_of(tree.nodes, [](const KdNode& node) {
            return !isLeaf(node) && nodeAxis(node) == 0 && nodePosition(node) == 0.25f;
        })) << "there is no plane in the wall";
        expectTreeOfExact(world);
    }
}

TEST(GpuExact, BuildsTheTreeOfExactOverSceneFiles) {
    for (const auto& file : sceneFiles(50'000)) {
        SCOPED_TRACE(file.string());
        expectTreeOfExact(pose(loadGltf(file)).triangles);
    }
}

TEST(GpuExact, BuildsOverAList) {
    const std::vector<Triangle> world = mixedTriangles(4000, 2);
    std::vector<uint32_t> list;
    for (uint32_t i = 0; i < world.size(); i += 2) list.push_back(i);
    GpuBuilder builder(device());
    const KdTree tree = readBack(*builder.build(DeviceTriangles(device(), world), exactly(), list).tree);
    EXPECT_EQ(treeHash(tree), treeHash(buildExact(makeTriangleSet(world, list), {})));
}

// A timed build is the same build, of other passes.
TEST(GpuExact, ProfilesItsPasses) {
    const DeviceTriangles triangles(device(), mixedTriangles(3000, 5));
    GpuBuilder builder(device());
    builder.build(triangles, exactly());
    const BuildProfile profile = builder.profile(triangles, exactly());
    const auto find = [&](std::string_view name) { return std::ranges::find(profile.passes, name, &PassWork::name); };
    for (const std::string_view binned : {"bounds", "bin", "choose_split", "nearest", "snap"})
        EXPECT_EQ(find(binned), profile.passes.end()) << binned;
    for (const std::string_view exact : {"clear_bins", "count_faces", "open_bins", "gather_faces", "choose_face"}) {
        ASSERT_NE(find(exact), profile.passes.end()) << exact;
        EXPECT_GT(find(exact)->runs, 0u) << exact;
    }
}

TEST(GpuExact, FinishesInLeavesWhereMemoryIsShort) {
    const std::vector<Triangle> world = mixedTriangles(20'000, 4);
    const TriangleSet set = makeTriangleSet(world);
    BuildSettings settings = exactly();
    settings.memory = uint64_t{9} << 20;
    GpuBuilder builder(device());
    const GpuBuilder::Result result = builder.build(DeviceTriangles(device(), world), settings);
    EXPECT_TRUE(result.memoryLimited);
    const KdTree tree = readBack(*result.tree);
    EXPECT_EQ(treeHash(tree), treeHash(buildTwin(set, settings).tree));
    const ValidationReport report = validate(tree, set, depthLimit(settings, set.included.size()));
    EXPECT_TRUE(report.ok()) << report.errors.front();
}

}  // namespace cleave::test
