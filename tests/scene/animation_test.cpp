// Animations of one triangle, whose places are worked out by hand.
#include <gtest/gtest.h>

#include <numbers>

#include "moving_triangle.h"
#include "scene/not_found.h"

namespace cleave::test {
namespace {

const float kHalfSqrt = float(std::sqrt(0.5));

void expectNear(const vec3& v, const vec3& expected, float tolerance = 1e-6f) {
    EXPECT_NEAR(glm::distance(v, expected), 0.0f, tolerance) << v.x << " " << v.y << " " << v.z;
}

TEST(PoseAnimation, stepsFromKeyToKey) {
    const Animated scene = Animated().add("translation", "STEP", {1, 2, 4}, {1, 0, 0, 2, 0, 0, 3, 0, 0});
    const std::vector<std::pair<double, float>> expected = {{-1, 1}, {0, 1},      {1, 1}, {1.9, 1}, {2, 2},
                                                            {3, 2},  {3.9999, 2}, {4, 3}, {99, 3}};
    for (const auto& [seconds, x] : expected) EXPECT_EQ(scene.at(seconds).triangles.at(0).a.x, x) << seconds;
}

TEST(PoseAnimation, isLinearBetweenKeys) {
    const Animated scene = Animated().add("translation", "LINEAR", {1, 2, 4}, {1, 0, 0, 2, 8, 0, 3, 0, 4});
    EXPECT_EQ(scene.at(0.5).triangles.at(0).a, vec3(1, 0, 0));
    EXPECT_EQ(scene.at(1.25).triangles.at(0).a, vec3(1.25f, 2, 0));
    EXPECT_EQ(scene.at(2).triangles.at(0).a, vec3(2, 8, 0));
    EXPECT_EQ(scene.at(3).triangles.at(0).a, vec3(2.5f, 4, 2));
    EXPECT_EQ(scene.at(5).triangles.at(0).a, vec3(3, 0, 4));
}

// Keys at 1 and 3 are values 0 and 4; the tangent out of the first is 2 and into the second -1, per second. Halfway the
// Hermite basis is 1/2, 1/8, 1/2, -1/8, and tangents count twice, as keys are two seconds apart.
TEST(PoseAnimation, followsACubicSpline) {
    const Animated scene = Animated().add("translation", "CUBICSPLINE", {1, 3},
                                          {99, 99, 99, 0, 5, 0, 2, 0, 0, -1, 0, 0, 4, 7, 0, 99, 99, 99});
    EXPECT_EQ(scene.at(0).triangles.at(0).a, vec3(0, 5, 0));
    EXPECT_EQ(scene.at(1).triangles.at(0).a, vec3(0, 5, 0));
    EXPECT_EQ(scene.at(2).triangles.at(0).a, vec3(2 + 0.5f + 0.25f, 6, 0));
    EXPECT_EQ(scene.at(3).triangles.at(0).a, vec3(4, 7, 0));
    EXPECT_EQ(scene.at(9).triangles.at(0).a, vec3(4, 7, 0));
}

// From no rotation to 90 degrees about z; b is the image of (1, 0, 0).
TEST(PoseAnimation, rotatesAtConstantSpeed) {
    const Animated scene = Animated().add("rotation", "LINEAR", {0, 3}, {0, 0, 0, 1, 0, 0, kHalfSqrt, kHalfSqrt});
    for (const double degrees : {0.0, 30.0, 60.0, 90.0}) {
        const double angle = degrees * std::numbers::pi / 180.0;
        expectNear(scene.at(degrees / 30.0).triangles.at(0).b, vec3(std::cos(angle), std::sin(angle), 0));
    }
}

// The second quaternion is 90 degrees about z with its sign turned: the same rotation, and still the shorter arc.
TEST(PoseAnimation, rotatesTheShorterWay) {
    const Animated scene = Animated().add("rotation", "LINEAR", {0, 2}, {0, 0, 0, 1, 0, 0, -kHalfSqrt, -kHalfSqrt});
    expectNear(scene.at(1).triangles.at(0).b, vec3(kHalfSqrt, kHalfSqrt, 0));
    const Animated still = Animated().add("rotation", "LINEAR", {0, 2}, {0, 0, 0, 1, 0, 0, 0, 1});
    EXPECT_EQ(still.at(1).triangles.at(0).b, vec3(1, 0, 0));
}

TEST(PoseAnimation, readsRotationsOfSmallIntegers) {
    Animated scene;
    Document& document = scene.add("rotation", "STEP", {0}, {0, 0, 0, 1}).document();
    document.json["animations"][0]["samplers"][0]["output"] = document.addAccessor(
        document.addView(bytesOf<int8_t>({0, 0, 127, 0})), 5120, 1, "VEC4", {{"normalized", true}});
    EXPECT_EQ(scene.at(0).triangles.at(0).b, vec3(-1, 0, 0));  // 180 degrees about z
}

TEST(PoseAnimation, movesTheNodesBelow) {
    Document document = triangleDocument();
    document.json["nodes"].push_back({{"children", {0}}, {"translation", {0, 0, 5}}, {"scale", {2, 2, 2}}});
    document.json["scenes"][0]["nodes"] = {1};
    document.node()["translation"] = {1, 0, 0};
    const Animated scene = Animated(document)
                               .add("scale", "LINEAR", {0, 1}, {2, 2, 2, 4, 4, 4}, 1)
                               .add("translation", "LINEAR", {0, 1}, {1, 0, 0, 1, 2, 0}, 0);
    // Scale 3, of (1, 0, 0) moved by (1, 1, 0), then the place that stays as it is.
    EXPECT_EQ(scene.at(0.5).triangles.at(0).b, vec3(6, 3, 5));
    EXPECT_EQ(pose(sceneOf(document)).triangles.at(0).b, vec3(4, 0, 5));
}

TEST(PoseAnimation, movesJoints) {
    const Animated scene = Animated(skinDocument()).add("translation", "LINEAR", {0, 1}, {0, 0, 0, 0, 0, 8}, 1);
    const Triangle t = scene.at(0.5).triangles.at(0);
    EXPECT_EQ(t.a, vec3(0, 0, 4));
    EXPECT_EQ(t.b, vec3(1, 20, 0));
}

TEST(PoseAnimation, changesWeights) {
    const Animated scene = Animated(morphDocument()).add("weights", "LINEAR", {0, 1}, {0, 1, 1, 0});
    const Triangle t = scene.at(0.75).triangles.at(0);
    EXPECT_EQ(t.a, vec3(0.75f, 1.5f, 2.25f));
    EXPECT_EQ(t.b, vec3(1, 0, 2));
    // Of the two weights' cubic splines, each key has tangents in, values, tangents out.
    const Animated cubic =
        Animated(morphDocument()).add("weights", "CUBICSPLINE", {0, 2}, {9, 9, 0, 1, 0, 0, 0, 0, 1, 0, 9, 9});
    EXPECT_EQ(cubic.at(1).triangles.at(0).a, vec3(0.5f, 1, 1.5f));
    EXPECT_EQ(cubic.at(1).triangles.at(0).b, vec3(1, 0, 4));
}

TEST(PoseAnimation, isNotPlayedInTheRestPose) {
    const Animated scene = Animated().add("translation", "STEP", {0}, {5, 0, 0});
    EXPECT_EQ(pose(sceneOf(Animated(scene).document())).triangles.at(0).a.x, 0.0f);
    EXPECT_EQ(scene.at(0, {}).triangles.at(0).a.x, 0.0f);
    EXPECT_EQ(scene.at(0).triangles.at(0).a.x, 5.0f);
}

TEST(PoseAnimation, theEarlierOfTwoThatCollideCounts) {
    Animated scene = Animated().add("translation", "STEP", {0}, {1, 0, 0}).next();
    scene.add("translation", "STEP", {0}, {2, 0, 0}).add("scale", "STEP", {0}, {3, 3, 3});
    const PosedScene both = scene.at(0, allAnimations(sceneOf(scene.document())));
    EXPECT_EQ(both.triangles.at(0).a.x, 1.0f);
    EXPECT_EQ(both.triangles.at(0).b.x, 4.0f);
    ASSERT_EQ(both.warnings.size(), 1u);
    EXPECT_TRUE(mentions(both.warnings, "animation 1, channel 0 is left out: an earlier channel moves the same"));
    EXPECT_EQ(scene.at(0, {1}).triangles.at(0).a.x, 2.0f);
    EXPECT_TRUE(scene.at(0, {1}).warnings.empty());
}

TEST(PoseAnimation, isChosenByNameThenByNumber) {
    Scene scene;
    scene.name = "scene";
    EXPECT_TRUE(chooseAnimation(scene, "").empty());
    EXPECT_THROW(chooseAnimation(scene, "0"), NotFound);
    scene.animations = {{"walk", {}, {}}, {"2", {}, {}}, {"run", {}, {}}};
    EXPECT_EQ(chooseAnimation(scene, ""), std::vector<uint32_t>{0});
    EXPECT_EQ(chooseAnimation(scene, "run"), std::vector<uint32_t>{2});
    EXPECT_EQ(chooseAnimation(scene, "2"), std::vector<uint32_t>{1});
    EXPECT_EQ(chooseAnimation(scene, "0"), std::vector<uint32_t>{0});
    EXPECT_EQ(allAnimations(scene), (std::vector<uint32_t>{0, 1, 2}));
    try {
        chooseAnimation(scene, "jump");
        FAIL();
    } catch (const NotFound& error) {
        EXPECT_NE(std::string(error.what()).find("0 'walk', 1 '2', 2 'run'"), std::string::npos) << error.what();
    }
}

TEST(PoseAnimation, leavesOutWhatItCannotPlay) {
    Animated matrix = Animated().add("translation", "STEP", {0}, {5, 0, 0});
    matrix.document().node()["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1};
    EXPECT_EQ(matrix.at(0).triangles.at(0).a.x, 7.0f);
    EXPECT_TRUE(mentions(matrix.at(0).warnings, "its node has a matrix"));

    Animated pointer = Animated().add("translation", "STEP", {0}, {5, 0, 0});
    pointer.document().json["animations"][0]["channels"][0]["target"] =
        Json::parse(R"({"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": "/nodes/0/scale"}}})");
    EXPECT_EQ(pointer.at(0).triangles.at(0).a.x, 0.0f);
    EXPECT_TRUE(mentions(sceneOf(pointer.document()).warnings, "animations[0].channels[0] uses KHR_animation_pointer"));
}

TEST(PoseAnimation, refusesTimesThatDoNotIncrease) {
    for (const Floats& times : {Floats{0, 0}, {1, 0}, {0, NAN}, {0, INFINITY}, {-INFINITY, 0}}) {
        const Animated scene = Animated().add("translation", "LINEAR", times, {5, 0, 0, 6, 0, 0});
        EXPECT_THROW(scene.at(0), Error);
        EXPECT_EQ(scene.at(0, {}).triangles.size(), 1u) << "keys that are not used are not read";
    }
    EXPECT_THROW(Animated().at(NAN), Error);
}

}  // namespace
}  // namespace cleave::test
