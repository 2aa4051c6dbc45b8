// EXT_mesh_gpu_instancing: instances are what as many nodes would be, in order.
#include <gtest/gtest.h>

#include "gltf_text.h"
#include "moving_triangle.h"

namespace cleave::test {
namespace {

void instance(Document& document, const Json& attributes) {
    document.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
}

int addVectors(Document& document, const Floats& values, int width) {
    return document.addAccessor(document.addView(bytesOf(values)), 5126, values.size() / size_t(width),
                                width == 3 ? "VEC3" : "VEC4");
}

const Floats kPlaces = {1, 2, 3, -4, 5, 0.25f};
const Floats kTurns = {0.5f, 0.5f, 0.5f, 0.5f, 0, 0, 0.6f, 0.8f};
const Floats kScales = {1, 2, 3, -1, 0.5f, 1};

// The triangle, two times, by a turned and scaled node.
Document instancedTwice() {
    Document document = triangleDocument();
    document.node()["matrix"] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7, 8, 9, 1};
    instance(document, {{"TRANSLATION", addVectors(document, kPlaces, 3)},
                        {"ROTATION", addVectors(document, kTurns, 4)},
                        {"SCALE", addVectors(document, kScales, 3)}});
    return document;
}

// The same by two child nodes.
Document twoNodes() {
    Document document = triangleDocument();
    document.node() = {{"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7, 8, 9, 1}}, {"children", {1, 2}}};
    for (size_t i = 0; i < 2; ++i) {
        const auto part = [&](const Floats& values, size_t width) {
            const auto at = values.begin() + std::ptrdiff_t(i * width);
            return Floats(at, at + std::ptrdiff_t(width));
        };
        document.json["nodes"].push_back({{"mesh", 0},
                                          {"translation", part(kPlaces, 3)},
                                          {"rotation", part(kTurns, 4)},
                                          {"scale", part(kScales, 3)}});
    }
    return document;
}

bool sameBytes(const PosedScene& a, const PosedScene& b) {
    return a.triangles.size() == b.triangles.size() &&
           std::memcmp(a.triangles.data(), b.triangles.data(), a.triangles.size() * sizeof(Triangle)) == 0;
}

TEST(Instancing, placesInstancesAsNodesWouldBe) {
    const PosedScene instanced = load(instancedTwice());
    EXPECT_TRUE(instanced.warnings.empty());
    ASSERT_EQ(instanced.triangles.size(), 2u);
    EXPECT_TRUE(sameBytes(instanced, load(twoNodes())));
    // By hand: (1,0,0) stays by the scale of instance 0, turns to (0,1,0), moves to (1,3,3); the node makes it this.
    EXPECT_EQ(instanced.triangles[0].b, vec3(-6 + 7, 2 + 8, 6 + 9));
}

TEST(Instancing, eachTransformMayBeMissing) {
    Document moved = triangleDocument();
    instance(moved, {{"TRANSLATION", addVectors(moved, {0, 0, 0, 10, 0, 0, 20, 0, 0}, 3)}});
    EXPECT_EQ(xOf(load(moved)), (Floats{0, 1, 0, 10, 11, 10, 20, 21, 20}));
    Document scaled = triangleDocument();
    instance(scaled, {{"SCALE", addVectors(scaled, {2, 1, 1, 3, 1, 1}, 3)}});
    EXPECT_EQ(xOf(load(scaled)), (Floats{0, 2, 0, 0, 3, 0}));
    Document custom = triangleDocument();
    instance(custom, {{"_ID", custom.addAccessor(-1, 5123, 3, "SCALAR")}});
    EXPECT_EQ(load(custom).triangles.size(), 3u);
    Document none = triangleDocument();
    instance(none, Json::object());
    EXPECT_EQ(load(none).triangles.size(), 1u);
    Document zero = triangleDocument();
    instance(zero, {{"SCALE", zero.addAccessor(-1, 5126, 0, "VEC3")}});
    EXPECT_EQ(load(zero).triangles.size(), 0u);
}

TEST(Instancing, readsRotationsThatAreNormalizedIntegers) {
    Document document = triangleDocument();
    const int view = document.addView(bytesOf<int8_t>({0, 0, 127, 0, 0, 0, 0, 127}));
    instance(document, {{"ROTATION", document.addAccessor(view, 5120, 2, "VEC4", {{"normalized", true}})}});
    EXPECT_EQ(xOf(load(document)), (Floats{0, -1, 0, 0, 1, 0}));  // a half turn about z, and none
}

// Numbering: each instance with all of its primitives, before the next one.
TEST(Instancing, numbersInstanceByInstance) {
    Document document = triangleDocument();
    const int other = document.addPositions({5, 0, 0, 6, 0, 0, 5, 1, 0});
    document.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", other}}}, {"material", 0}});
    document.json["materials"] = {Json::object()};
    instance(document, {{"TRANSLATION", addVectors(document, {0, 0, 0, 10, 0, 0}, 3)}});
    const PosedScene scene = load(document);
    EXPECT_EQ(xOf(scene), (Floats{0, 1, 0, 5, 6, 5, 10, 11, 10, 15, 16, 15}));
    EXPECT_EQ(scene.materialOf, (std::vector<uint32_t>{1, 0, 1, 0}));
}

TEST(Instancing, countsWhatEachInstanceLeavesOut) {
    Document document = triangleDocument();
    document.primitive()["mode"] = 0;
    instance(document, {{"SCALE", document.addAccessor(-1, 5126, 5, "VEC3")}});
    EXPECT_EQ(load(document).leftOut.at("points"), 15u);
    document.json["accessors"][0] = {{"componentType", 5126}, {"count", uint64_t(1) << 48}, {"type", "VEC3"}};
    document.json["accessors"][1]["count"] = uint64_t(1) << 48;  // the product is 2^96
    EXPECT_EQ(load(document).leftOut.at("points"), uint64_t(1) << 62);
}

TEST(Instancing, movesWithItsNode) {
    Document document = triangleDocument();
    instance(document, {{"TRANSLATION", addVectors(document, {0, 0, 0, 10, 0, 0}, 3)}});
    Animated animated(document);
    animated.add("translation", "LINEAR", {0, 1}, {0, 0, 0, 100, 0, 0});
    EXPECT_EQ(xOf(animated.at(0.5)), (Floats{50, 51, 50, 60, 61, 60}));
}

TEST(Instancing, warnsWhereItCannotPlaceThem) {
    Document skinned = skinDocument();
    instance(skinned, {{"SCALE", skinned.addAccessor(-1, 5126, 5, "VEC3")}});
    const PosedScene once = load(skinned);
    EXPECT_EQ(once.triangles.size(), 1u);
    EXPECT_TRUE(mentions(once.warnings, "node 0 is shown once: it has instances, and also a skin"));

    Document nowhere = triangleDocument();
    nowhere.json["buffers"] = {
        {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + base64(nowhere.data)}},
        {{"byteLength", 24}}};
    nowhere.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 24}});
    instance(nowhere, {{"TRANSLATION", nowhere.addAccessor(1, 5126, 2, "VEC3")}});
    const PosedScene placed = load(nowhere);
    EXPECT_EQ(placed.triangles.size(), 1u);
    EXPECT_TRUE(mentions(placed.warnings, "node 0 is shown once: it has instances, and their data is in a buffer"));
}

// A few hundred bytes may ask for any number of them: transforms without a bufferView are zeros.
TEST(Instancing, boundsTheTriangles) {
    Document document = triangleDocument();
    instance(document, {{"SCALE", document.addAccessor(-1, 5126, kMostTriangles + 1, "VEC3")}});
    EXPECT_NE(refusal(document).find("more than"), std::string::npos);
    document.json["accessors"][1]["count"] = uint64_t(1) << 48;
    document.json["accessors"][0] = {{"componentType", 5126}, {"count", 3 << 16}, {"type", "VEC3"}};
    EXPECT_NE(refusal(document).find("more than"), std::string::npos);  // 2^64 of them
    document.json["accessors"][0]["count"] = 3;
    document.json["accessors"][1]["count"] = 1000;
    const Scene scene = sceneOf(document);
    EXPECT_EQ(pose(scene, {}, 1000).triangles.size(), 1000u);
    EXPECT_THROW(pose(scene, {}, 999), Error);
}

}  // namespace
}  // namespace cleave::test
