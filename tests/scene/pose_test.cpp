// Skins, morph targets and lights, on one triangle whose vertices are worked out by hand.
#include <gtest/gtest.h>

#include "moving_triangle.h"

namespace cleave::test {
namespace {

TEST(PoseSkin, sumsJointMatricesByWeight) {
    const Triangle t = load(skinDocument()).triangles.at(0);
    EXPECT_EQ(t.a, vec3(10, 0, 0));
    EXPECT_EQ(t.b, vec3(1, 20, 0));
    EXPECT_EQ(t.c, vec3(5, 11, 0));  // half of (10, 1, 0) and of (0, 21, 0)
}

TEST(PoseSkin, appliesInverseBindMatricesFirst) {
    Document document = skinDocument();
    const Floats halve = {0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 1};
    const Floats back = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -20, 0, 1};
    Floats both = halve;
    both.insert(both.end(), back.begin(), back.end());
    document.json["skins"][0]["inverseBindMatrices"] =
        document.addAccessor(document.addView(bytesOf(both)), 5126, 2, "MAT4");
    const Triangle t = load(document).triangles.at(0);
    EXPECT_EQ(t.a, vec3(10, 0, 0));
    EXPECT_EQ(t.b, vec3(1, 0, 0));      // its joint's matrix undoes its joint's place
    EXPECT_EQ(t.c, vec3(5, 0.75f, 0));  // half of (10, 0.5, 0) and of (0, 1, 0)
}

TEST(PoseSkin, followsTheParentsOfJoints) {
    Document document = skinDocument();
    document.json["nodes"].push_back({{"translation", {0, 0, 7}}, {"children", {1, 2}}});
    document.json["scenes"][0]["nodes"] = {0};  // the joints need not be shown
    const Triangle t = load(document).triangles.at(0);
    EXPECT_EQ(t.a, vec3(10, 0, 7));
    EXPECT_EQ(t.b, vec3(1, 20, 7));
}

TEST(PoseSkin, dividesByTheSumOfWeights) {
    const Triangle t = load(skinDocument({0.5f, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0})).triangles.at(0);
    EXPECT_EQ(t.a, vec3(10, 0, 0));
    EXPECT_EQ(t.b, vec3(1, 20, 0));
    EXPECT_EQ(t.c, vec3(10, 1, 0)) << "without a weight it follows its first joint";
}

TEST(PoseSkin, readsFurtherSetsOfJoints) {
    Document document = skinDocument();
    const auto& attributes = document.primitive()["attributes"];
    const int joints = attributes["JOINTS_0"];
    const int weights = document.addAccessor(document.addView(bytesOf<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0})),
                                             5121, 3, "VEC4", {{"normalized", true}});
    const Triangle t = load(withAttributes({{"JOINTS_1", joints}, {"WEIGHTS_1", weights}}, document)).triangles.at(0);
    EXPECT_EQ(t.a, vec3(10, 0, 0));
    EXPECT_EQ(t.c, vec3(2.5f, 16, 0));  // weights 0.5 and 1.5 of 2: a quarter of (10, 1, 0), the rest of (0, 21, 0)
}

TEST(PoseSkin, refusesJointsThatTheSkinDoesNotHave) {
    Document document = skinDocument();
    document.json["skins"][0]["joints"] = {1};
    const std::string message = refusal(document);
    EXPECT_NE(message.find("node 0, primitive 0: JOINTS_0 of vertex 1 holds 1, and there are 1 joints"),
              std::string::npos)
        << message;
}

TEST(PoseSkin, isPlacedByItsNodeWithoutJoints) {
    Document document = skinDocument();
    document.primitive()["attributes"].erase("WEIGHTS_0");
    const PosedScene scene = load(document);
    EXPECT_EQ(scene.triangles.at(0).b, vec3(101, 100, 100));
    EXPECT_TRUE(mentions(scene.warnings, "node 0, primitive 0 is skinned, and has no JOINTS_0 or no WEIGHTS_0"));
}

TEST(PoseMorph, appliesDefaultWeights) {
    const Triangle t = load(morphDocument()).triangles.at(0);
    EXPECT_EQ(t.a, vec3(0.5f, 1, 1.5f));
    EXPECT_EQ(t.b, vec3(1, 0, 2));
    EXPECT_EQ(t.c, vec3(0, 1, 0));
}

TEST(PoseMorph, prefersTheWeightsOfTheNode) {
    Document document = morphDocument();
    document.node()["weights"] = {0, 1};
    const Triangle t = load(document).triangles.at(0);
    EXPECT_EQ(t.a, vec3(0));
    EXPECT_EQ(t.b, vec3(1, 0, 8));
    document.node().erase("weights");
    document.json["meshes"][0].erase("weights");
    EXPECT_EQ(load(document).triangles.at(0).b, vec3(1, 0, 0));
}

TEST(PoseMorph, comesBeforeTheSkin) {
    Document document = skinDocument();
    const int deltas = document.addPositions({1, 2, 3, 0, 0, 0, 0, 0, 0});
    document.primitive()["targets"] = {{{"POSITION", deltas}}};
    document.json["meshes"][0]["weights"] = {1};
    EXPECT_EQ(load(document).triangles.at(0).a, vec3(11, 2, 3));
}

// KHR_mesh_quantization allows deltas of small integers, normalised or not.
TEST(PoseMorph, readsQuantizedDeltas) {
    Document document = triangleDocument();
    const int whole = document.addAccessor(document.addView(bytesOf<int8_t>({3, -2, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0}), 4),
                                           5120, 3, "VEC3");
    const int shares =
        document.addAccessor(document.addView(bytesOf<int16_t>({0, 0, 0, 0, 32767, -32768, 0, 0, 0, 0, 0, 0}), 8), 5122,
                             3, "VEC3", {{"normalized", true}});
    document.primitive()["targets"] = {{{"POSITION", whole}}, {{"POSITION", shares}}};
    document.json["meshes"][0]["weights"] = {1, 2};
    const Triangle t = load(document).triangles.at(0);
    EXPECT_EQ(t.a, vec3(3, -2, 0));
    EXPECT_EQ(t.b, vec3(3, -2, 0));
    EXPECT_EQ(t.c, vec3(0, 1, 4));
}

TEST(PoseLights, arePlacedByTheirNodes) {
    Document document = triangleDocument();
    document.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([
        {"type": "point", "intensity": 5, "color": [1, 0.5, 0.25], "range": 9},
        {"type": "spot", "name": "lamp", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}])");
    document.json["nodes"].push_back(Json::parse(R"({"translation": [1, 2, 3], "scale": [0, 0, 0],
        "extensions": {"KHR_lights_punctual": {"light": 0}}})"));
    document.json["nodes"].push_back(Json::parse(R"({"rotation": [0, 0.7071067811865476, 0, 0.7071067811865476],
        "extensions": {"KHR_lights_punctual": {"light": 1}}})"));
    document.json["nodes"].push_back(Json::parse(R"({"scale": [0, 0, 0],
        "extensions": {"KHR_lights_punctual": {"light": 1}}})"));
    document.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const Scene scene = sceneOf(document);
    EXPECT_EQ(scene.lights.at(0).colour, glm::dvec3(1, 0.5, 0.25));
    EXPECT_EQ(scene.lights[0].range, 9.0);
    EXPECT_EQ(scene.lights[1].outerConeAngle, 0.2);
    const PosedScene posed = pose(scene);
    ASSERT_EQ(posed.lights.size(), 2u);
    EXPECT_EQ(posed.lights[0].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(posed.lights[1].light, 1u);
    EXPECT_NEAR(glm::distance(posed.lights[1].direction, glm::dvec3(-1, 0, 0)), 0.0, 1e-15);
    EXPECT_TRUE(mentions(posed.warnings, "node 3 has a light that is nowhere, or has no direction"));
}

TEST(Pose, givesTheSameBytesTwice) {
    const Scene scene = sceneOf(
        Animated(skinDocument()).add("rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0.6f, 0, 0, 0.8f}, 1).document());
    for (const PoseTime& time : {PoseTime{}, PoseTime{0.3, {0}}}) {
        const PosedScene first = pose(scene, time);
        const PosedScene second = pose(scene, time);
        EXPECT_EQ(std::memcmp(first.triangles.data(), second.triangles.data(), sizeof(Triangle)), 0);
    }
}

// A file of a few kilobytes may ask for any amount of work: triangles by instances, times morph targets.
TEST(Pose, boundsItsWork) {
    Document document;
    document.addMesh(document.addAccessor(-1, 5126, 3 << 12, "VEC3"));
    const int deltas = document.addAccessor(-1, 5126, 3 << 12, "VEC3");
    document.primitive()["targets"] = Json(100, Json{{"POSITION", deltas}});
    document.json["meshes"][0]["weights"] = Json(100, 1.0);
    const Scene scene = sceneOf(document);
    EXPECT_EQ(pose(scene).triangles.size(), size_t(1) << 12);
    EXPECT_THROW(pose(scene, {}, size_t(1) << 12), Error);
    EXPECT_THROW(pose(scene, {}, (size_t(1) << 12) - 1), Error);
}

}  // namespace
}  // namespace cleave::test
