// Which triangles a primitive becomes, in which order, and what is left out.
#include <gtest/gtest.h>

#include "scene/gltf_text.h"

namespace cleave::test {
namespace {

using Floats = std::vector<float>;

// Vertices 0 to 5 at x = 0 to 5.
int addSix(Document& document) { return document.addPositions({0, 0, 0, 1, 1, 0, 2, 0, 0, 3, 1, 0, 4, 0, 0, 5, 1, 0}); }

PosedScene sixWithMode(int mode) {
    Document document;
    document.addMesh(addSix(document), -1, {{"mode", mode}});
    return load(document);
}

template <typename Index>
PosedScene sixWithIndices(const std::vector<Index>& indices, const Json& more = Json::object()) {
    Document document;
    const int positions = addSix(document);
    document.addMesh(positions, document.addIndices(indices), more);
    return load(document);
}

TEST(GltfPrimitive, readsEveryIndexType) {
    const Floats expected = {5, 0, 3};
    EXPECT_EQ(xOf(sixWithIndices<uint8_t>({5, 0, 3})), expected);
    EXPECT_EQ(xOf(sixWithIndices<uint16_t>({5, 0, 3})), expected);
    EXPECT_EQ(xOf(sixWithIndices<uint32_t>({5, 0, 3})), expected);
}

TEST(GltfPrimitive, countsVerticesWithoutIndices) { EXPECT_EQ(xOf(sixWithMode(4)), (Floats{0, 1, 2, 3, 4, 5})); }

// glTF 2.0, section 3.7.2.1: p_i = {v_i, v_(i+1+i%2), v_(i+2-i%2)}.
TEST(GltfPrimitive, turnsEveryOtherTriangleOfAStrip) {
    EXPECT_EQ(xOf(sixWithMode(5)), (Floats{0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}));
    EXPECT_EQ(xOf(sixWithIndices<uint16_t>({5, 4, 3, 2}, {{"mode", 5}})), (Floats{5, 4, 3, 4, 2, 3}));
}

// p_i = {v_(i+1), v_(i+2), v_0}.
TEST(GltfPrimitive, putsTheCentreOfAFanLast) {
    EXPECT_EQ(xOf(sixWithMode(6)), (Floats{1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0}));
    EXPECT_EQ(xOf(sixWithIndices<uint8_t>({3, 1, 5, 2}, {{"mode", 6}})), (Floats{1, 5, 3, 5, 2, 3}));
}

TEST(GltfPrimitive, leavesOutPointsAndLines) {
    const std::vector<uint64_t> lines = {0, 3, 6, 5};  // of six vertices, by mode
    for (int mode = 0; mode < 4; ++mode) {
        PosedScene scene = sixWithMode(mode);
        EXPECT_TRUE(scene.triangles.empty());
        EXPECT_EQ(scene.leftOut["points"], mode == 0 ? 6u : 0u);
        EXPECT_EQ(scene.leftOut["lines"], lines[size_t(mode)]) << "mode " << mode;
    }
}

TEST(GltfPrimitive, keepsTheGoodPartOfASurplus) {
    PosedScene scene = sixWithIndices<uint8_t>({0, 1, 2, 3, 4});
    EXPECT_EQ(xOf(scene), (Floats{0, 1, 2}));
    EXPECT_EQ(scene.leftOut["surplusIndices"], 2u);
    EXPECT_TRUE(mentions(scene.warnings, "5 indices"));
    EXPECT_EQ(sixWithIndices<uint8_t>({0, 1}, {{"mode", 5}}).leftOut["surplusIndices"], 2u);
}

TEST(GltfPrimitive, leavesOutWhatHasNoPosition) {
    Document document = triangleDocument();
    document.primitive()["attributes"] = {{"NORMAL", 0}};
    PosedScene scene = load(document);
    EXPECT_TRUE(scene.triangles.empty());
    EXPECT_EQ(scene.leftOut["primitivesWithoutPosition"], 1u);
}

TEST(GltfPrimitive, namesMaterialsAndEndsWithTheDefault) {
    Document document = triangleDocument();
    document.json["materials"] = Json::parse(
        R"([{"name": "a"}, {"name": "b", "pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 2, 0.75]}}])");
    document.addMesh(0, -1, {{"material", 1}});
    document.json["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = sceneOf(document);
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(pose(scene).materialOf, (std::vector<uint32_t>{2, 1}));
    EXPECT_EQ(scene.materials[0].baseColour, glm::vec4(1.0f));
    EXPECT_EQ(scene.materials[1].baseColour, glm::vec4(0.25f, 0.5f, 1.0f, 0.75f));  // clamped to [0, 1]
    EXPECT_EQ(scene.materials[2].baseColour, glm::vec4(1.0f));
}

TEST(GltfPrimitive, keepsNonFiniteTrianglesAndNamesTheFirst) {
    Document document;
    document.addMesh(document.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, NAN, 0, 0, 1, 0, 0, 0, INFINITY, 0}));
    const PosedScene scene = load(document);
    ASSERT_EQ(scene.triangles.size(), 2u);
    EXPECT_TRUE(isNan(scene.triangles[1].a.x));
    EXPECT_TRUE(mentions(scene.warnings, "1 triangles have a vertex that is not finite, the first is number 1"));
}

}  // namespace
}  // namespace cleave::test
