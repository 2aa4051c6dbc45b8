// Scene order, world placement, cameras.
#include <gtest/gtest.h>

#include "scene/gltf_text.h"

namespace cleave::test {
namespace {

// Nodes that all show the one triangle; its vertex b is the image of (1, 0, 0).
Document nodesDocument(const std::string& nodes, const std::vector<int>& roots) {
    Document document = triangleDocument();
    document.json["nodes"] = Json::parse(nodes);
    document.json["scenes"][0]["nodes"] = roots;
    return document;
}

TEST(GltfNodes, goDepthFirstInListedOrder) {
    const Document document = nodesDocument(R"([
        {"mesh": 0, "translation": [10, 0, 0]},
        {"mesh": 0, "translation": [20, 0, 0], "children": [3, 2]},
        {"mesh": 0, "translation": [1, 0, 0]},
        {"mesh": 0, "translation": [2, 0, 0], "children": [4]},
        {"mesh": 0, "translation": [0.5, 0, 0]}])",
                                            {1, 0});
    std::vector<float> first;
    for (const Triangle& t : load(document).triangles) first.push_back(t.a.x);
    EXPECT_EQ(first, (std::vector<float>{20, 22, 22.5f, 21, 10}));
}

TEST(GltfNodes, applyScaleThenRotationThenTranslation) {
    // 90 degrees about z turns (2, 0, 0) into (0, 2, 0); the mirrored y axis turns (0, -3, 0) into (3, 0, 0).
    const PosedScene scene = load(nodesDocument(R"([{"mesh": 0, "translation": [10, 20, 30], "scale": [2, -3, 1],
        "rotation": [0, 0, 0.70710678, 0.70710678]}])",
                                                {0}));
    const Triangle& t = scene.triangles.at(0);
    EXPECT_EQ(t.a, vec3(10, 20, 30));
    EXPECT_NEAR(glm::distance(t.b, vec3(10, 22, 30)), 0.0f, 2e-6f);
    EXPECT_NEAR(glm::distance(t.c, vec3(13, 20, 30)), 0.0f, 2e-6f);
}

TEST(GltfNodes, multiplyMatricesColumnByColumn) {
    // Outer: x -> y -> z -> x, and moved by (100, 0, 0); inner: twice as large, moved by (1, 2, 3).
    const PosedScene scene = load(nodesDocument(R"([
        {"matrix": [0,1,0,0, 0,0,1,0, 1,0,0,0, 100,0,0,1], "children": [1]},
        {"mesh": 0, "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 1,2,3,1]}])",
                                                {0}));
    const Triangle& t = scene.triangles.at(0);
    EXPECT_EQ(t.a, vec3(103, 1, 2));
    EXPECT_EQ(t.b, vec3(103, 3, 2));  // (1,0,0) -> (3,2,3) -> (3+100,3,2)
    EXPECT_EQ(t.c, vec3(103, 1, 4));
}

// In float, 1e8 + 1 - 1e8 would be 0: positions are rounded once, at the end.
TEST(GltfNodes, roundOnce) {
    const PosedScene scene = load(nodesDocument(
        R"([{"translation": [-1e8, 0, 0], "children": [1]}, {"mesh": 0, "translation": [1e8, 0, 0]}])", {0}));
    EXPECT_EQ(scene.triangles.at(0).b.x, 1.0f);
}

TEST(GltfNodes, takeTheDefaultSceneOrTheFirstOrAllRoots) {
    Document document =
        nodesDocument(R"([{"mesh": 0, "children": [2]}, {"mesh": 0, "translation": [5, 0, 0]}, {"mesh": 0}])", {0});
    document.json["scenes"].push_back({{"nodes", {1}}});
    EXPECT_EQ(load(document).triangles.size(), 2u);
    document.json["scene"] = 1;
    EXPECT_EQ(load(document).triangles.at(0).a.x, 5.0f);
    document.json.erase("scene");
    EXPECT_EQ(load(document).triangles.size(), 2u);
    document.json.erase("scenes");
    EXPECT_EQ(load(document).triangles.size(), 3u);
}

TEST(GltfNodes, mayFormALongChain) {
    constexpr int kNodes = 100000;  // would overflow the stack if it were walked by recursion
    Json nodes = Json::array();
    for (int i = 0; i + 1 < kNodes; ++i) nodes.push_back({{"translation", {0, 0, 1}}, {"children", {i + 1}}});
    nodes.push_back({{"mesh", 0}});
    EXPECT_EQ(load(nodesDocument(nodes.dump(), {0})).triangles.at(0).a.z, float(kNodes - 1));
}

TEST(GltfNodes, survivesATransformThatOverflows) {
    const PosedScene scene =
        load(nodesDocument(R"([{"scale": [1e300, 1, 1], "children": [1]}, {"mesh": 0, "scale": [1e300, 1, 1]}])", {0}));
    ASSERT_EQ(scene.triangles.size(), 1u);
    EXPECT_TRUE(mentions(scene.warnings, "not finite"));
}

TEST(GltfCamera, isPlacedByItsNode) {
    // A node turned by 90 degrees about y looks along -x; its scale does not count.
    Document document = nodesDocument(R"([
        {"mesh": 0}, {"camera": 1, "name": "side", "translation": [1, 2, 3], "scale": [5, 5, 5],
                      "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]}, {"camera": 0}])",
                                      {0, 1, 2});
    document.json["cameras"] = Json::parse(R"([
        {"name": "main", "type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 2, "znear": 0, "zfar": 10}}])");
    const PosedScene scene = load(document);
    ASSERT_EQ(scene.cameras.size(), 2u);
    const Camera& side = scene.cameras[0];
    EXPECT_EQ(side.name, "side");
    EXPECT_TRUE(side.orthographic);
    EXPECT_EQ(side.orthographicHeight, 4.0);
    EXPECT_EQ(side.eye, glm::dvec3(1, 2, 3));
    EXPECT_NEAR(glm::distance(side.forward, glm::dvec3(-1, 0, 0)), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(side.up, glm::dvec3(0, 1, 0)), 0.0, 1e-15);
    EXPECT_EQ(scene.cameras[1].name, "main");
    EXPECT_EQ(scene.cameras[1].verticalFov, 0.5);
    EXPECT_EQ(scene.cameras[1].forward, glm::dvec3(0, 0, -1));
}

TEST(GltfCamera, thatShowsNothingIsIgnored) {
    Document document = nodesDocument(R"([{"mesh": 0}, {"camera": 0}, {"camera": 1, "scale": [0, 0, 0]}])", {0, 1, 2});
    document.json["cameras"] = Json::parse(R"([
        {"type": "perspective", "perspective": {"yfov": 4, "znear": 0.1}},
        {"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}])");
    const PosedScene scene = load(document);
    EXPECT_TRUE(scene.cameras.empty());
    EXPECT_EQ(scene.warnings.size(), 2u);
}

}  // namespace
}  // namespace cleave::test
