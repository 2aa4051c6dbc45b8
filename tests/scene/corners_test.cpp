// What pose gives of corners, where somebody asks for it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "moving_triangle.h"

namespace cleave::test {
namespace {

PosedScene withCorners(const Document& document) {
    return pose(sceneOf(document), {}, kMostTriangles, Detail::corners);
}

int add(Document& document, const Floats& values, int width) {
    static const char* const kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    return document.addAccessor(document.addView(bytesOf(values)), 5126, values.size() / size_t(width), kTypes[width]);
}

void set(Document& document, const char* semantic, int accessor, size_t primitive = 0) {
    document.json["meshes"][0]["primitives"][primitive]["attributes"][semantic] = accessor;
}

// A second triangle of the mesh, without anything but positions.
void addPlainPrimitive(Document& document, bool first) {
    Json& primitives = document.json["meshes"][0]["primitives"];
    const Json plain = {{"attributes", {{"POSITION", 0}}}};
    if (first)
        primitives.insert(primitives.begin(), plain);
    else
        primitives.push_back(plain);
}

Document withNormals(const Floats& normals = {0, 0, 1, 0, 0, 2, 0, 0, 1}) {
    Document document = triangleDocument();
    set(document, "NORMAL", add(document, normals, 3));
    return document;
}

void expectNear(const vec3& got, const glm::dvec3& expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], 1e-6) << got.x << " " << got.y << " " << got.z;
}

TEST(Corners, areEmptyUnlessAskedForOrWhereNothingIs) {
    const PosedScene plain = load(withNormals());
    EXPECT_TRUE(plain.corners.normals.empty());
    const PosedScene nothing = withCorners(triangleDocument());
    EXPECT_EQ(nothing.triangles.size(), 1u);
    EXPECT_TRUE(nothing.corners.normals.empty() && nothing.corners.colours.empty());
    EXPECT_TRUE(nothing.corners.texCoords[0].empty() && nothing.corners.texCoords[1].empty());
}

// The normal of a plane stays normal to it, whatever a node does to the plane; a mirror turns it around as it does
// faces (glTF 2.0, section 3.7.4).
TEST(Corners, normalsStayNormalToTheirTriangle) {
    const std::vector<std::pair<const char*, double>> transforms = {
        {R"({"scale": [3, 0.5, 2]})", 1.0},
        {R"({"rotation": [0.5, 0.5, 0.5, 0.5], "scale": [1, 2, 7]})", 1.0},
        {R"({"matrix": [1,0,0,0, 0.5,1,0.25,0, 3,-2,1,0, 7,8,9,1]})", 1.0},
        {R"({"scale": [1, 1, -2]})", -1.0},
        {R"({"rotation": [0.6, 0, 0, 0.8], "scale": [-1, 3, 1]})", -1.0},
        {R"({"scale": [1, 1, 0]})", 1.0},
        {R"({"scale": [1e-200, 1e-200, 1e-200]})", 1.0},
        {R"({"scale": [1e200, 1e200, 1e200]})", 1.0}};
    for (const auto& [node, facing] : transforms) {
        Document document = withNormals();
        document.node().update(Json::parse(node));
        const PosedScene scene = withCorners(document);
        ASSERT_EQ(scene.corners.normals.size(), 3u);
        const Triangle t = scene.triangles.at(0);
        const glm::dvec3 across = glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a));
        for (const vec3& normal : scene.corners.normals) {
            EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f) << node;
            if (!(glm::length(across) > 0.0) || std::isinf(t.b.x)) continue;  // beyond floats
            expectNear(normal, facing * glm::normalize(across));
        }
    }
}

TEST(Corners, normalsWithoutADirectionAreZero) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const PosedScene scene = withCorners(withNormals({0, 0, 0, nan, 0, 1, 3, 4, 0}));
    expectNear(scene.corners.normals.at(0), {0, 0, 0});
    expectNear(scene.corners.normals.at(1), {0, 0, 0});
    expectNear(scene.corners.normals.at(2), {0.6, 0.8, 0});
    Document flat = withNormals({1, 0, 0, 1, 0, 0, 1, 0, 0});
    flat.node()["scale"] = {1, 1, 0};  // all that was normal to z is gone
    expectNear(withCorners(flat).corners.normals.at(0), {0, 0, 0});
}

TEST(Corners, normalsFollowMorphTargetsAndJoints) {
    Document morphed = withNormals();
    morphed.primitive()["targets"] = {{{"POSITION", 0}, {"NORMAL", add(morphed, {1, 0, 0, 0, 0, 0, 0, 1, 0}, 3)}}};
    morphed.json["meshes"][0]["weights"] = {0.75};
    const PosedScene moved = withCorners(morphed);
    expectNear(moved.corners.normals.at(0), {0.6, 0, 0.8});
    expectNear(moved.corners.normals.at(1), {0, 0, 1});
    expectNear(moved.corners.normals.at(2), {0, 0.6, 0.8});

    Document skinned = skinDocument();
    set(skinned, "NORMAL", add(skinned, {0, 0, 1, 0, 0, 1, 0, 0, 1}, 3));
    skinned.node()["rotation"] = {0, 1, 0, 0};  // does not count
    skinned.json["nodes"][1]["rotation"] = {0.7071067811865476, 0, 0, 0.7071067811865476};
    const PosedScene scene = withCorners(skinned);
    expectNear(scene.corners.normals.at(0), {0, -1, 0});
    expectNear(scene.corners.normals.at(1), {0, 0, 1});
}

TEST(Corners, readEveryFormatOfTextureCoordinates) {
    Document document = triangleDocument();
    set(document, "TEXCOORD_0", add(document, {0, 0.25f, -3, 4, 1, NAN}, 2));
    const int view = document.addView(bytesOf<uint8_t>({0, 255, 0, 0, 51, 102, 0, 0, 255, 0, 0, 0}), 4);
    set(document, "TEXCOORD_1", document.addAccessor(view, 5121, 3, "VEC2", {{"normalized", true}}));
    const CornerAttributes corners = withCorners(document).corners;
    EXPECT_EQ(corners.texCoords[0], (std::vector<glm::vec2>{{0, 0.25f}, {-3, 4}, {1, 0}}));
    EXPECT_EQ(corners.texCoords[1], (std::vector<glm::vec2>{{0, 1}, {0.2f, 0.4f}, {1, 0}}));
    EXPECT_TRUE(corners.colours.empty());
}

TEST(Corners, readEveryFormatOfColours) {
    Document floats = triangleDocument();
    set(floats, "COLOR_0", add(floats, {0, 0.25f, 0.5f, 0.75f, -1, 2, 1e30f, 1, NAN, 1, 1, 0}, 4));
    EXPECT_EQ(withCorners(floats).corners.colours,
              (std::vector<glm::vec4>{{0, 0.25f, 0.5f, 0.75f}, {0, 1, 1, 1}, {0, 1, 1, 0}}));
    Document bytes = triangleDocument();
    const int view = bytes.addView(bytesOf<uint8_t>({0, 51, 255, 0, 255, 255, 0, 0, 102, 0, 0, 0}), 4);
    set(bytes, "COLOR_0", bytes.addAccessor(view, 5121, 3, "VEC3", {{"normalized", true}}));
    EXPECT_EQ(withCorners(bytes).corners.colours,
              (std::vector<glm::vec4>{{0, 0.2f, 1, 1}, {1, 1, 0, 1}, {0.4f, 0, 0, 1}}));
}

// Triangles without something, before and after those that have it, are given what they are without.
TEST(Corners, fillUpWhereATriangleHasNothing) {
    for (const bool before : {false, true}) {
        Document document = withNormals();
        set(document, "TEXCOORD_1", add(document, {1, 2, 3, 4, 5, 6}, 2));
        set(document, "COLOR_0", add(document, Floats(9, 0.5f), 3));
        addPlainPrimitive(document, before);
        const PosedScene scene = withCorners(document);
        ASSERT_EQ(scene.triangles.size(), 2u);
        ASSERT_EQ(scene.corners.normals.size(), 6u);
        ASSERT_EQ(scene.corners.texCoords[1].size(), 6u);
        ASSERT_EQ(scene.corners.colours.size(), 6u);
        EXPECT_TRUE(scene.corners.texCoords[0].empty());
        const size_t has = before ? 3 : 0;
        const size_t lacks = 3 - has;
        expectNear(scene.corners.normals[has], {0, 0, 1});
        expectNear(scene.corners.normals[lacks], {0, 0, 0});
        EXPECT_EQ(scene.corners.texCoords[1][has + 1], glm::vec2(3, 4));
        EXPECT_EQ(scene.corners.texCoords[1][lacks + 1], glm::vec2(0));
        EXPECT_EQ(scene.corners.colours[has], glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
        EXPECT_EQ(scene.corners.colours[lacks], glm::vec4(1));
    }
}

// Corners come in the order of those of the triangle, by indices, for each instance.
TEST(Corners, belongToTheirTriangles) {
    Document document;
    const int positions = document.addPositions({0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 1, 0});
    document.addMesh(positions, document.addIndices<uint8_t>({0, 1, 2, 3}), {{"mode", 5}});
    set(document, "TEXCOORD_0", add(document, {0, 0, 1, 0, 2, 0, 3, 0}, 2));
    document.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", add(document, {0, 0, 0, 0, 5, 0}, 3)}};
    const PosedScene scene = withCorners(document);
    const Floats xs = xOf(scene);
    ASSERT_EQ(xs.size(), 12u);
    ASSERT_EQ(scene.corners.texCoords[0].size(), 12u);
    for (size_t i = 0; i < 12; ++i) EXPECT_EQ(scene.corners.texCoords[0][i].x, xs[i]) << i;
}

TEST(Corners, leaveOutWhatTheyCannotRead) {
    Document document = withNormals();
    set(document, "TEXCOORD_0", add(document, {0, 0, 0, 1, 1, 1, 2, 2, 2}, 3));
    set(document, "COLOR_0", document.addAccessor(document.addView(std::string(36, '\0')), 5125, 3, "VEC3"));
    document.json["buffers"] = {{{"byteLength", document.data.size()},
                                 {"uri", "data:application/octet-stream;base64," + base64(document.data)}},
                                {{"byteLength", 24}}};
    document.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 24}});
    set(document, "TEXCOORD_1", document.addAccessor(int(document.json["bufferViews"].size()) - 1, 5126, 3, "VEC2"));
    const PosedScene scene = withCorners(document);
    EXPECT_EQ(scene.corners.normals.size(), 3u);
    EXPECT_TRUE(scene.corners.texCoords[0].empty() && scene.corners.texCoords[1].empty());
    EXPECT_TRUE(scene.corners.colours.empty());
    for (const char* warning : {"TEXCOORD_0 is left out: it has a format", "COLOR_0 is left out: it has a format",
                                "TEXCOORD_1 is left out: its data is in a buffer that is not there"})
        EXPECT_TRUE(mentions(scene.warnings, warning)) << warning;
    EXPECT_TRUE(pose(sceneOf(document)).warnings.empty());  // nobody asked
}

}  // namespace
}  // namespace cleave::test
