// The kernels that pose, against the host's pose, which shares nothing with them but the transform of a point: every
// bit of every vertex that is finite.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "run/poser.h"
#include "scene/moving_nodes.h"
#include "scene/moving_triangle.h"
#include "scene/pose_tables.h"
#include "support/animated_scenes.h"
#include "support/device.h"

namespace cleave::test {
namespace {

constexpr uint64_t kEnough = uint64_t{1} << 30;

Poser& poser() {
    static std::unique_ptr<Poser> made;
    if (!made) {
        made = std::make_unique<Poser>(device());
        beforeClose([] { made.reset(); });
    }
    return *made;
}

std::vector<float> numbersOf(const std::vector<Triangle>& triangles) {
    std::vector<float> numbers;
    for (const Triangle& t : triangles)
        for (const vec3& v : {t.a, t.b, t.c}) numbers.insert(numbers.end(), {v.x, v.y, v.z});
    return numbers;
}

void expectSame(const std::vector<Triangle>& device, const std::vector<Triangle>& host) {
    const std::vector<float> seen = numbersOf(device), wanted = numbersOf(host);
    ASSERT_EQ(seen.size(), wanted.size());
    for (size_t i = 0; i < seen.size(); ++i) {
        if (isNan(wanted[i]))
            ASSERT_TRUE(isNan(seen[i])) << "triangle " << i / 9;
        else
            ASSERT_EQ(floatBitsToUint(seen[i]), floatBitsToUint(wanted[i]))
                << "triangle " << i / 9 << ", number " << i % 9 << ": " << std::hexfloat << seen[i] << " and "
                << wanted[i];
    }
}

// Poses at the times on the device, one after the other. What moves is not where it was at first; what does not stays.
void expectAsTheHost(const Scene& scene, const std::vector<double>& times, const std::vector<uint32_t>& animations) {
    const std::vector<bool> moving = movingNodes(scene, animations);
    const PosedScene first = pose(scene, {times.front(), animations});
    const auto tables = poseTables(scene, first, moving, kEnough);
    if (countMoving(first, moving) == 0) {
        EXPECT_FALSE(tables);
        return;
    }
    ASSERT_TRUE(tables);
    EXPECT_EQ(tables->numbers, trianglesThat(true, first, moving));
    std::vector<Triangle> there = first.triangles;
    const Triangle nowhere{vec3(7.0f), vec3(8.0f), vec3(9.0f)};
    for (const uint32_t number : tables->numbers) there[number] = nowhere;
    const DeviceTriangles triangles(device(), there);
    DevicePose made(device(), PoseArrays{tables->parts, tables->positions, tables->morphs, tables->deltas,
                                         tables->influences, tables->corners, tables->numbers, tables->vertices});
    for (const double seconds : times) {
        SCOPED_TRACE(seconds);
        const PoseMotion motion = poseMotion(scene, {seconds, animations}, moving);
        poser().pose(made, motion.maps, motion.weights, triangles);
        expectSame(triangles.triangles.download<Triangle>(triangles.count),
                   pose(scene, {seconds, animations}).triangles);
    }
}

void expectAsTheHost(const Animated& animated) {
    expectAsTheHost(animated.scene(), {0.0, 0.3, 0.77, 1.0, 0.123456}, {0});
}

TEST(Pose, EqualsTheHostsInScenesThatAreAnimated) {
    size_t scenes = 0;
    forAnimatedScenes([&](const std::filesystem::path& file, const Scene& scene, const std::vector<double>& times) {
        SCOPED_TRACE(file.string());
        expectAsTheHost(scene, times, allAnimations(scene));
        ++scenes;
    });
    EXPECT_GE(scenes, 3u);
}

// A grid of n x n points in many triangles, of which some are used by none, with attributes at random.
class Grid {
  public:
    explicit Grid(uint32_t seed) : random_(seed) {}

    Floats some(size_t count, float low, float high) {
        Floats values(count);
        for (float& v : values) v = std::uniform_real_distribution<float>(low, high)(random_);
        return values;
    }
    Document document(uint32_t vertices, uint32_t triangles, float scale = 1.0f) {
        Document document;
        std::vector<uint16_t> indices(3 * triangles);
        for (uint16_t& i : indices) i = static_cast<uint16_t>(random_() % vertices);
        document.addMesh(document.addPositions(some(3 * vertices, -scale, scale)), document.addIndices(indices));
        return document;
    }
    // With so many sets of joints, whose weights make no sum in particular.
    Document skinned(uint32_t vertices, uint32_t triangles, int sets, uint32_t joints) {
        Document made = document(vertices, triangles);
        for (int set = 0; set < sets; ++set) {
            std::vector<uint16_t> numbers(4 * vertices);
            for (uint16_t& n : numbers) n = static_cast<uint16_t>(random_() % joints);
            Floats weights = some(4 * vertices, 0.0f, 1.0f);
            for (size_t i = 0; i < weights.size(); ++i)
                if (random_() % 3 == 0 || i / 4 % 5 == 0) weights[i] = 0.0f;  // some vertices have none at all
            const std::string name = std::to_string(set);
            made.primitive()["attributes"]["JOINTS_" + name] =
                made.addAccessor(made.addView(bytesOf(numbers)), 5123, vertices, "VEC4");
            made.primitive()["attributes"]["WEIGHTS_" + name] =
                made.addAccessor(made.addView(bytesOf(weights)), 5126, vertices, "VEC4");
        }
        Json list = Json::array();
        for (uint32_t j = 0; j < joints; ++j) {
            list.push_back(j + 1);
            const Floats turn = some(4, -1, 1), move = some(3, -2, 2), size = some(3, 0.5f, 2);
            made.json["nodes"].push_back({{"rotation", turn}, {"translation", move}, {"scale", size}});
            made.json["scenes"][0]["nodes"].push_back(j + 1);
        }
        made.json["skins"] = {{{"joints", list}}};
        made.node()["skin"] = 0;
        return made;
    }
    void addTargets(Document& document, uint32_t vertices, size_t count) {
        for (size_t i = 0; i < count; ++i)
            document.primitive()["targets"].push_back({{"POSITION", document.addPositions(some(3 * vertices, -1, 1))}});
    }

  private:
    std::mt19937 random_;
};

TEST(Pose, EqualsTheHostsOfNodes) {
    Grid grid(1);
    Animated animated = Animated(grid.document(300, 1000))
                            .add("rotation", "LINEAR", {0, 1}, grid.some(8, -1, 1))
                            .add("scale", "CUBICSPLINE", {0, 1}, grid.some(18, 0.5f, 2))
                            .add("translation", "LINEAR", {0, 1}, grid.some(6, -100, 100));
    expectAsTheHost(animated);
}

TEST(Pose, EqualsTheHostsOfSkins) {
    for (const int sets : {1, 2}) {
        Grid grid(static_cast<uint32_t>(10 + sets));
        Animated animated = Animated(grid.skinned(300, 1000, sets, 7))
                                .add("rotation", "LINEAR", {0, 1}, grid.some(8, -1, 1), 3)
                                .add("translation", "LINEAR", {0, 1}, grid.some(6, -3, 3), 5);
        expectAsTheHost(animated);
    }
}

// Of three targets one has no weight at some times: what is 0 then is not added, even where it is infinite. Nor do
// vertices follow a joint, which is infinitely far off, if its weight is 0.
TEST(Pose, EqualsTheHostsOfMorphTargetsAndSkins) {
    Grid grid(20);
    Document document = grid.skinned(200, 700, 1, 4);
    grid.addTargets(document, 200, 3);
    const size_t delta = document.primitive()["targets"][0]["POSITION"];
    const size_t view = document.json["accessors"][delta]["bufferView"];
    char* deltas = document.data.data() + size_t(document.json["bufferViews"][view]["byteOffset"]);
    const float infinite = infinity();
    for (size_t vertex = 100; vertex < 120; ++vertex) std::memcpy(deltas + 12 * vertex, &infinite, sizeof(infinite));
    document.node(4)["scale"] = {1e300, 1e300, 1e300};
    document.node(4)["translation"] = {1e300, 1e300, 1e300};
    document.json["nodes"].push_back({{"scale", {1e300, 1e300, 1e300}}, {"children", {4}}});
    document.json["scenes"][0]["nodes"] = {0, 1, 2, 3, 5};
    Animated animated = Animated(document)
                            .add("weights", "LINEAR", {0, 1}, {0, 0.3f, 0.7f, 1, -0.4f, 0.2f})
                            .add("scale", "LINEAR", {0, 1}, grid.some(6, 0.1f, 3), 2);
    expectAsTheHost(animated);
}

TEST(Pose, EqualsTheHostsOfNodesWithWeightsOfTheirOwn) {
    Grid grid(25);
    Document document = grid.document(200, 700);
    grid.addTargets(document, 200, 2);
    document.json["nodes"].push_back({{"mesh", 0}, {"translation", {3, 0, 0}}, {"weights", {0.5, 0.25}}});
    document.json["nodes"].push_back({{"mesh", 0}, {"translation", {6, 0, 0}}});
    document.json["scenes"][0]["nodes"] = {0, 1, 2};
    Animated animated = Animated(document)
                            .add("weights", "LINEAR", {0, 1}, {0, 1, 1, 0.1f}, 0)
                            .add("weights", "LINEAR", {0, 1}, {0.2f, 0.7f, -1, 2}, 2)
                            .add("scale", "LINEAR", {0, 1}, {1, 1, 1, 2, 2, 2}, 1);
    expectAsTheHost(animated);
}

// Several primitives and nodes of one mesh, instances, and a mesh that stays between them.
TEST(Pose, EqualsTheHostsInManyPlaces) {
    Grid grid(30);
    Document document = grid.document(50, 90);
    for (const int mode : {5, 6, 4}) {
        Json primitive = document.primitive();
        primitive["mode"] = mode;
        document.json["meshes"][0]["primitives"].push_back(primitive);
    }
    document.json["nodes"].push_back({{"mesh", 0}});  // stays
    document.json["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}, {"children", {3}}});
    const int moves = document.addAccessor(document.addView(bytesOf(grid.some(15, -4, 4))), 5126, 5, "VEC3");
    const int turns = document.addAccessor(document.addView(bytesOf(grid.some(20, -1, 1))), 5126, 5, "VEC4");
    document.json["nodes"].push_back({{"mesh", 0}});
    document.json["nodes"][3]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", moves},
                                                                                        {"ROTATION", turns}};
    document.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    document.json["scenes"][0]["nodes"] = {2, 1, 0};
    Animated animated = Animated(document)
                            .add("rotation", "LINEAR", {0, 1}, grid.some(8, -1, 1), 2)
                            .add("translation", "LINEAR", {0, 1}, grid.some(6, -3, 3), 0);
    const Scene scene = animated.scene();
    ASSERT_EQ(countMoving(pose(scene), movingNodes(scene, {0})), (1u + 1u + 5u) * (90u + 90u + 2u * 268u));
    expectAsTheHost(animated);
}

// Accessors that are normalised, sparse, or without data.
TEST(Pose, EqualsTheHostsOfAccessorsOfAnyKind) {
    Grid grid(40);
    Document document = triangleDocument();
    document.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    const std::vector<int16_t> quantized{-32768, 32767, 5, 77, -3, 1000, 3, 2, 1};
    document.primitive()["attributes"]["POSITION"] =
        document.addAccessor(document.addView(bytesOf(quantized)), 5122, 3, "VEC3", {{"normalized", true}});
    const int where = document.addView(bytesOf(std::vector<uint16_t>{1}));
    const int what = document.addView(bytesOf(Floats{0.1f, 0.2f, 0.3f}));
    const Json sparse = {{"sparse",
                          {{"count", 1},
                           {"indices", {{"bufferView", where}, {"componentType", 5123}}},
                           {"values", {{"bufferView", what}}}}}};
    document.primitive()["targets"] = {{{"POSITION", document.addAccessor(-1, 5126, 3, "VEC3", sparse)}},
                                       {{"NORMAL", document.addAccessor(-1, 5126, 3, "VEC3")}},
                                       {{"POSITION", document.addPositions(grid.some(9, -1, 1))}}};
    Animated animated = Animated(document).add("weights", "LINEAR", {0, 1}, {0, 0.3f, 0.7f, 1, -0.4f, 0.2f});
    expectAsTheHost(animated);
}

// Down to where floats have fewer digits, and devices may have none; and out of their range.
TEST(Pose, EqualsTheHostsFromTheSmallestFloatsToInfinity) {
    for (const float scale : {1e-45f, 1e-41f, 1e-39f, 1e-38f, 1e-30f, 1e37f, 3e38f}) {
        Grid grid(50);
        SCOPED_TRACE(scale);
        Animated animated = Animated(grid.document(100, 300, scale))
                                .add("rotation", "LINEAR", {0, 1}, grid.some(8, -1, 1))
                                .add("scale", "LINEAR", {0, 1}, {-1, 1, 1, 2, 0, 3});
        expectAsTheHost(animated);
    }
}

TEST(PoseTables, AreNotMadeWhereTheHostHasToSaySomething) {
    Grid grid(60);
    Document document = grid.document(100, 300);
    grid.addTargets(document, 100, 2);
    const auto tablesOf = [](const Document& made, uint64_t bytes) {
        Animated animated = Animated(made).add("weights", "LINEAR", {0, 1}, {0, 0, 1, 1});
        Json& json = animated.document().json;
        json["buffers"] = {{{"byteLength", animated.document().data.size()},
                            {"uri", "data:application/octet-stream;base64," + base64(animated.document().data)}},
                           {{"byteLength", animated.document().data.size()}}};
        const Scene scene = animated.scene();
        return poseTables(scene, pose(scene, {0.0, {0}}), movingNodes(scene, {0}), bytes).has_value();
    };
    EXPECT_TRUE(tablesOf(document, kEnough));
    EXPECT_FALSE(tablesOf(document, 9000)) << "they take more";
    const int target = document.primitive()["targets"][1]["POSITION"];
    document.json["bufferViews"][size_t(document.json["accessors"][size_t(target)]["bufferView"])]["buffer"] = 1;
    EXPECT_FALSE(tablesOf(document, kEnough)) << "what has a weight later is nowhere";
}

}  // namespace
}  // namespace cleave::test
