// Posing what moves alone gives what posing all gives, to the last bit.
#include "scene/pose_again.h"

#include <gtest/gtest.h>

#include <cstring>

#include "moving_triangle.h"
#include "scene/moving_nodes.h"
#include "scene/shared_pose.h"
#include "support/animated_scenes.h"

namespace cleave::test {
namespace {

template <typename Item>
bool haveSameBits(const std::vector<Item>& a, const std::vector<Item>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0);
}

void expectSame(const PosedScene& again, const PosedScene& whole) {
    EXPECT_TRUE(haveSameBits(again.triangles, whole.triangles));
    EXPECT_TRUE(haveSameBits(again.materialOf, whole.materialOf));
    EXPECT_TRUE(haveSameBits(again.sides, whole.sides));
    EXPECT_TRUE(haveSameBits(again.corners.normals, whole.corners.normals));
    EXPECT_TRUE(haveSameBits(again.corners.texCoords[0], whole.corners.texCoords[0]));
    EXPECT_TRUE(haveSameBits(again.corners.texCoords[1], whole.corners.texCoords[1]));
    EXPECT_TRUE(haveSameBits(again.corners.colours, whole.corners.colours));
    EXPECT_EQ(again.leftOut, whole.leftOut);
    EXPECT_EQ(nonFiniteWarning(again), nonFiniteWarning(std::span<const Triangle>(whole.triangles)));
    ASSERT_EQ(again.meshes.size(), whole.meshes.size());
    for (size_t i = 0; i < whole.meshes.size(); ++i) EXPECT_EQ(again.meshes[i].triangles, whole.meshes[i].triangles);
    ASSERT_EQ(again.cameras.size(), whole.cameras.size());
    for (size_t i = 0; i < whole.cameras.size(); ++i) EXPECT_EQ(again.cameras[i].eye, whole.cameras[i].eye);
    ASSERT_EQ(again.lights.size(), whole.lights.size());
    for (size_t i = 0; i < whole.lights.size(); ++i) EXPECT_EQ(again.lights[i].position, whole.lights[i].position);
}

TEST(PoseAgain, givesWhatPosingAllGives) {
    size_t scenes = 0;
    forAnimatedScenes([&](const std::filesystem::path& file, const Scene& scene, const std::vector<double>& times) {
        SCOPED_TRACE(file.string());
        const std::vector<uint32_t> animations = allAnimations(scene);
        const std::vector<bool> moving = movingNodes(scene, animations);
        for (const Detail detail : {Detail::triangles, Detail::corners}) {
            PosedScene again = pose(scene, {times.front(), animations}, kMostTriangles, detail);
            for (const double seconds : times) {
                SCOPED_TRACE(seconds);
                EXPECT_TRUE(poseAgain(again, scene, {seconds, animations}, moving, detail));
                expectSame(again, pose(scene, {seconds, animations}, kMostTriangles, detail));
            }
        }
        ++scenes;
    });
    EXPECT_GE(scenes, 3u);
}

// What stays is not even looked at: marks that are put there stay, too.
TEST(PoseAgain, leavesAloneWhatDoesNotMove) {
    const Scene scene = loadGltf(CLEAVE_SOURCE "/scenes/features/animation.glb");
    const std::vector<bool> moving = movingNodes(scene, {0});
    PosedScene again = pose(scene, {0.0, {0}});
    const Triangle mark{vec3(1.0f), vec3(2.0f), vec3(3.0f)};
    const PosedScene before = again;
    for (Triangle& t : again.triangles) t = mark;
    EXPECT_TRUE(poseAgain(again, scene, {0.5, {0}}, moving));
    std::vector<uint32_t> marked;
    for (uint32_t i = 0; i < again.triangles.size(); ++i)
        if (std::memcmp(&again.triangles[i], &mark, sizeof(mark)) == 0) marked.push_back(i);
    EXPECT_EQ(marked, trianglesThat(false, before, moving));
    EXPECT_FALSE(marked.empty());
    EXPECT_LT(marked.size(), again.triangles.size());
}

TEST(PoseAgain, turnsSides) {
    Animated mirrored = Animated().add("scale", "STEP", {0, 1}, {1, 1, 1, -1, 1, 1});
    const Scene scene = sceneOf(mirrored.document());
    PosedScene again = pose(scene, {0.0, {0}}, kMostTriangles, Detail::corners);
    const std::vector<uint32_t> before = again.sides;
    EXPECT_TRUE(poseAgain(again, scene, {1.0, {0}}, {true}, Detail::corners));
    EXPECT_NE(again.sides, before);
    expectSame(again, pose(scene, {1.0, {0}}, kMostTriangles, Detail::corners));
}

// The triangle of node 0 flies from where floats end to where they do not; that of node 1 stays.
TEST(PoseAgain, tellsOfAllThatIsNotFinite) {
    Document document = triangleDocument();
    document.json["nodes"].push_back({{"mesh", 0}, {"scale", {1e39, 1, 1}}});
    document.json["scenes"][0]["nodes"] = {1, 0};
    Animated far = Animated(document).add("translation", "STEP", {0, 1}, {0, 0, 0, 3e38f, 3e38f, 3e38f}, 0);
    far.add("scale", "STEP", {0, 1}, {1, 1, 1, 3e38f, 1, 1}, 0);
    const Scene scene = sceneOf(far.document());
    const std::vector<bool> moving = movingNodes(scene, {0});
    ASSERT_EQ(moving, std::vector<bool>({true, false}));
    PosedScene again = pose(scene, {0.0, {0}});
    for (const double seconds : {1.0, 0.0, 1.0}) {
        EXPECT_TRUE(poseAgain(again, scene, {seconds, {0}}, moving));
        expectSame(again, pose(scene, {seconds, {0}}));
        EXPECT_TRUE(mentions(again.warnings, seconds == 0.0 ? "1 triangles" : "2 triangles"));
    }
}

// A target whose data is nowhere leaves its primitive out, as long as it has a weight.
Scene sceneThatLosesAMesh() {
    Document document = morphDocument();
    const int nowhere = document.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
    document.primitive()["targets"][1]["POSITION"] = nowhere;
    Animated animated = Animated(document)
                            .add("weights", "LINEAR", {0, 1}, {0.5f, 0.0f, 0.5f, 1.0f})
                            .add("scale", "LINEAR", {0, 1}, {1, 1, 1, 2, 2, 2});
    Json& json = animated.document().json;
    json["buffers"] = {{{"byteLength", animated.document().data.size()},
                        {"uri", "data:application/octet-stream;base64," + base64(animated.document().data)}},
                       {{"byteLength", animated.document().data.size()}}};
    json["bufferViews"][size_t(json["accessors"][size_t(nowhere)]["bufferView"])]["buffer"] = 1;
    return sceneOf(animated.document());
}

TEST(PoseAgain, posesAllWhereTheFileLacksWhatATimeNeeds) {
    const Scene scene = sceneThatLosesAMesh();
    const std::vector<bool> moving = movingNodes(scene, {0});
    PosedScene again = pose(scene, {0.0, {0}});
    ASSERT_EQ(again.triangles.size(), 1u);
    EXPECT_FALSE(poseAgain(again, scene, {0.5, {0}}, moving));
    EXPECT_TRUE(again.triangles.empty());
    EXPECT_TRUE(mentions(again.warnings, "is left out"));
    EXPECT_FALSE(poseAgain(again, scene, {0.0, {0}}, moving));
    expectSame(again, pose(scene, {0.0, {0}}));
    EXPECT_TRUE(poseAgain(again, scene, {0.0, {0}}, moving));
}

}  // namespace
}  // namespace cleave::test
