// Which nodes move: channels by hand, and scenes whose triangles are looked at from time to time.
#include "scene/moving_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "moving_triangle.h"
#include "scene/key_values.h"

namespace cleave::test {
namespace {

using Moving = std::vector<bool>;

Moving movingOf(Animated& animated, const std::vector<uint32_t>& animations = {0}) {
    return movingNodes(sceneOf(animated.document()), animations);
}

// Node 0 shows a triangle; 1 is its parent, 2 the parent of that.
Document chainDocument() {
    Document document = triangleDocument();
    document.json["nodes"].push_back({{"children", {0}}});
    document.json["nodes"].push_back({{"children", {1}}});
    document.json["scenes"][0]["nodes"] = {2};
    return document;
}

TEST(MovingNodes, whatMovesTakesAlongWhatIsBelow) {
    for (const char* path : {"translation", "rotation", "scale"}) {
        const bool turns = path[0] == 'r';
        const Floats values = turns ? Floats{0, 0, 0, 1, 0, 0, 1, 0} : Floats{1, 1, 1, 1, 1, 2};
        Animated top = Animated(chainDocument()).add(path, "LINEAR", {0, 1}, values, 2);
        EXPECT_EQ(movingOf(top), Moving({true, true, true})) << path;
        Animated middle = Animated(chainDocument()).add(path, "STEP", {0, 1}, values, 1);
        EXPECT_EQ(movingOf(middle), Moving({true, true, false})) << path;
        Animated bottom = Animated(chainDocument()).add(path, "LINEAR", {0, 1}, values, 0);
        EXPECT_EQ(movingOf(bottom), Moving({true, false, false})) << path;
    }
}

TEST(MovingNodes, onlyWhatIsPlayedMoves) {
    Animated two = Animated(chainDocument()).add("translation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0}, 2);
    two.next().add("scale", "LINEAR", {0, 1}, {1, 1, 1, 2, 2, 2}, 0);
    EXPECT_EQ(movingOf(two, {}), Moving({false, false, false}));
    EXPECT_EQ(movingOf(two, {0}), Moving({true, true, true}));
    EXPECT_EQ(movingOf(two, {1}), Moving({true, false, false}));
    EXPECT_EQ(movingOf(two, {1, 0}), Moving({true, true, true}));
    // A node with a matrix is not animated.
    two.document().node(2)["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_EQ(movingOf(two, {0}), Moving({false, false, false}));
}

// The earlier of two channels that move the same thing counts, and here its keys are all alike.
TEST(MovingNodes, keysThatAreAllAlikeMoveNothing) {
    const Floats far{9, 9, 9, 9, 9, 9}, away{0, 0, 0, 1, 0, 0};
    Animated still = Animated().add("translation", "LINEAR", {0, 1}, far);
    still.next().add("translation", "LINEAR", {0, 1}, away);
    EXPECT_EQ(movingOf(still, {0, 1}), Moving{false});
    EXPECT_EQ(movingOf(still, {1, 0}), Moving{true});
    Animated oneKey = Animated().add("rotation", "LINEAR", {1}, {0, 0, 1, 0});
    EXPECT_EQ(movingOf(oneKey), Moving{false});
    Animated late = Animated().add("scale", "LINEAR", {0, 1, 2}, {2, 2, 2, 2, 2, 2, 2, 2, 2.5f});
    EXPECT_EQ(movingOf(late), Moving{true});
    // Between keys that are alike a spline may swing, as its tangents say.
    Animated swings =
        Animated().add("translation", "CUBICSPLINE", {0, 1}, {0, 0, 0, 1, 1, 1, 5, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0});
    EXPECT_EQ(movingOf(swings), Moving{true});
}

TEST(MovingNodes, timesThatDoNotIncreaseAreRefused) {
    Animated wrong = Animated().add("translation", "LINEAR", {1, 1}, {0, 0, 0, 1, 0, 0});
    try {
        movingOf(wrong);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("scene.gltf"), std::string::npos) << error.what();
    }
}

// A sum of two shares of a number would be an ulp off at some of these times.
TEST(MovingNodes, whatDoesNotMoveStaysToTheLastBit) {
    const Floats place{0.1f, 0.7f, -0.3f, 0.1f, 0.7f, -0.3f}, turn{0.1f, 0.2f, 0.3f, 0.9f, 0.1f, 0.2f, 0.3f, 0.9f};
    Animated still = Animated().add("translation", "LINEAR", {0, 1}, place).add("rotation", "LINEAR", {0, 1}, turn);
    EXPECT_EQ(movingOf(still), Moving{false});
    const Scene scene = sceneOf(still.document());
    const std::vector<double> times{0, 1};
    const std::vector<gltf::AnimationSampler>& samplers = scene.animations[0].samplers;
    const KeyValues places(scene, samplers[0], times), turns(scene, samplers[1], times);
    for (int i = 1; i < 1000; ++i) {
        EXPECT_EQ(places.vec3At(i / 1000.0), places.vec3At(0.0)) << i;
        EXPECT_EQ(turns.rotationAt(i / 1000.0), turns.rotationAt(0.0)) << i;
    }
}

// A skinned mesh moves with its joints, not with its node.
TEST(MovingNodes, skinsMoveWithTheirJoints) {
    const Floats away{0, 0, 0, 1, 0, 0};
    Animated node = Animated(skinDocument()).add("translation", "LINEAR", {0, 1}, away, 0);
    EXPECT_EQ(movingOf(node), Moving({false, false, false}));
    Animated joint = Animated(skinDocument()).add("translation", "LINEAR", {0, 1}, away, 2);
    EXPECT_EQ(movingOf(joint), Moving({true, false, true}));
    joint.document().json["skins"][0]["joints"] = {1, 1};
    EXPECT_EQ(movingOf(joint), Moving({false, false, true}));
}

TEST(MovingNodes, weightsMoveTheMeshOfTheirNodeAlone) {
    Document document = morphDocument();
    document.json["nodes"].push_back({{"mesh", 0}});
    document.json["scenes"][0]["nodes"] = {0, 1};
    Animated weights = Animated(document).add("weights", "LINEAR", {0, 1}, {0, 0, 0, 1}, 1);
    EXPECT_EQ(movingOf(weights), Moving({false, true}));
    Animated still = Animated(document).add("weights", "LINEAR", {0, 1}, {0.3f, 0.7f, 0.3f, 0.7f}, 1);
    EXPECT_EQ(movingOf(still), Moving({false, false}));
}

// Of each triangle, whether it differs between two of a hundred times.
std::vector<bool> seenToMove(const Scene& scene) {
    const std::vector<Triangle> first = pose(scene, {0.0, {0}}).triangles;
    std::vector<bool> moved(first.size());
    for (int i = 1; i < 100; ++i) {
        const std::vector<Triangle> now = pose(scene, {i / 20.0, {0}}).triangles;
        for (size_t t = 0; t < first.size(); ++t)
            if (std::memcmp(&first[t], &now[t], sizeof(Triangle)) != 0) moved[t] = true;
    }
    return moved;
}

TEST(MovingNodes, theyHoldWhatIsSeenToMove) {
    for (const char* name : {"animation", "morph_target", "skin"}) {
        const Scene scene = loadGltf(std::string(CLEAVE_SOURCE "/scenes/features/") + name + ".glb");
        const PosedScene rest = pose(scene);
        const std::vector<bool> moving = movingNodes(scene, {0});
        const std::vector<bool> seen = seenToMove(scene);
        size_t first = 0;
        for (const ShownMesh& mesh : rest.meshes) {
            const auto begin = seen.begin() + ptrdiff_t(first);
            const bool moves =
                std::find(begin, begin + ptrdiff_t(mesh.triangles), true) != begin + ptrdiff_t(mesh.triangles);
            EXPECT_EQ(moves, moving[mesh.node]) << name << ", node " << mesh.node;
            first += mesh.triangles;
        }
        EXPECT_EQ(first, rest.triangles.size()) << name;
        const uint64_t count = countMoving(rest, moving);
        EXPECT_GT(count, 0u) << name;
        EXPECT_LT(count, rest.triangles.size()) << name << ": the floor stays";
    }
}

}  // namespace
}  // namespace cleave::test
