// Skins, morph targets and animations, on one triangle whose vertices are worked out by hand.
#include <gtest/gtest.h>

#include <numbers>

#include "gltf_text.h"
#include "scene/not_found.h"

namespace cleave::test {
namespace {

using Floats = std::vector<float>;

const float kHalfSqrt = float(std::sqrt(0.5));

void expectNear(const vec3& v, const vec3& expected, float tolerance = 1e-6f) {
    EXPECT_NEAR(glm::distance(v, expected), 0.0f, tolerance) << v.x << " " << v.y << " " << v.z;
}

// The triangle (0,0,0), (1,0,0), (0,1,0) with more attributes, on node 0.
Document withAttributes(const std::vector<std::pair<const char*, int>>& attributes, Document document) {
    for (const auto& [semantic, accessor] : attributes) document.primitive()["attributes"][semantic] = accessor;
    return document;
}

// Nodes 1 and 2 are joints. Vertex a follows joint 0, vertex b joint 1, vertex c both alike.
Document skinDocument(const Floats& weights = {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}) {
    Document document = triangleDocument();
    const int joints =
        document.addAccessor(document.addView(bytesOf<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0})), 5121, 3, "VEC4");
    const int weight = document.addAccessor(document.addView(bytesOf(weights)), 5126, 3, "VEC4");
    document.json["skins"] = {{{"joints", {1, 2}}}};
    document.node()["skin"] = 0;
    document.node()["translation"] = {100, 100, 100};  // does not count
    document.json["nodes"].push_back({{"translation", {10, 0, 0}}});
    document.json["nodes"].push_back({{"translation", {0, 20, 0}}});
    document.json["scenes"][0]["nodes"] = {0, 1, 2};
    return withAttributes({{"JOINTS_0", joints}, {"WEIGHTS_0", weight}}, document);
}

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

// Target 0 moves vertex a by (1, 2, 3), target 1 vertex b by (0, 0, 8).
Document morphDocument() {
    Document document = triangleDocument();
    const int first = document.addPositions({1, 2, 3, 0, 0, 0, 0, 0, 0});
    const int second = document.addPositions({0, 0, 0, 0, 0, 8, 0, 0, 0});
    document.primitive()["targets"] = {{{"POSITION", first}}, {{"POSITION", second}}};
    document.json["meshes"][0]["weights"] = {0.5, 0.25};
    return document;
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

// Animation of node 0 by one channel with keys at the given times.
class Animated {
  public:
    explicit Animated(Document document = triangleDocument()) : document_(std::move(document)) {}

    Animated& add(const char* path, const char* interpolation, const Floats& times, const Floats& values,
                  int node = 0) {
        const int width = path[0] == 'r' ? 4 : path[0] == 'w' ? 1 : 3;
        const int input = document_.addAccessor(document_.addView(bytesOf(times)), 5126, times.size(), "SCALAR");
        const int output =
            document_.addAccessor(document_.addView(bytesOf(values)), 5126, values.size() / size_t(width),
                                  width == 4   ? "VEC4"
                                  : width == 1 ? "SCALAR"
                                               : "VEC3");
        Json& animation = document_.json["animations"][animation_];
        animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
        return *this;
    }
    Animated& next() {
        ++animation_;
        return *this;
    }
    PosedScene at(double seconds, const std::vector<uint32_t>& animations = {0}) const {
        return pose(sceneOf(document_), {seconds, animations});
    }
    Document& document() { return document_; }

  private:
    Document document_;
    size_t animation_ = 0;
};

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
