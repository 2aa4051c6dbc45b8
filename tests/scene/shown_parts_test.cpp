// What only other scenes of a file show is not read.
#include "scene/shown_parts.h"

#include <gtest/gtest.h>

#include "scene/gltf_text.h"

namespace cleave::test {
namespace {

// Two scenes of a triangle each; that of the second is in a file that is not there.
Document twoScenes() {
    Document document;
    document.addMesh(document.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    document.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 36}});
    document.addMesh(document.addAccessor(1, 5126, 3, "VEC3"));
    document.json["scenes"].push_back({{"nodes", {1}}});
    document.json["buffers"] = {
        {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + base64(document.data)}},
        {{"byteLength", 36}, {"uri", "missing.bin"}}};
    return document;
}

TEST(ShownParts, WhatOtherScenesShowIsNotRead) {
    const Folder folder;
    Document document = twoScenes();
    const Scene scene = loadGltf(folder.write("a.gltf", document.text()));
    EXPECT_EQ(scene.unusedMeshes, 1u);
    EXPECT_EQ(scene.unusedBuffers, 1u);
    EXPECT_EQ(scene.warnings, std::vector<std::string>{});
    EXPECT_EQ(pose(scene).triangles.size(), 1u);
    EXPECT_THROW(loadGltf(folder.path() / "a.gltf", Reading::everything), Error);
    document.json["scene"] = 1;
    EXPECT_THROW(loadGltf(folder.write("b.gltf", document.text())), Error) << "now it is shown";
}

TEST(ShownParts, AllIsReadWhereAllIsShown) {
    const Folder folder;
    Document document = twoScenes();
    document.json["scenes"] = {{{"nodes", {0, 1}}}};
    folder.write("missing.bin", document.data);
    const Scene scene = loadGltf(folder.write("a.gltf", document.text()));
    EXPECT_EQ(scene.unusedMeshes, 0u);
    EXPECT_EQ(scene.unusedBuffers, 0u);
    EXPECT_EQ(pose(scene).triangles.size(), 2u);
}

// Every view that something shown can need: images, animations, targets, sparse parts.
TEST(ShownParts, ViewsAreFoundByAllWaysThatLeadToThem) {
    Scene scene;
    scene.bufferViews.resize(10);
    scene.buffers.resize(1);
    for (uint32_t view = 0; view < 10; ++view) {
        gltf::Accessor accessor;
        accessor.view = view;
        scene.accessors.push_back(accessor);
    }
    scene.accessors[1].sparse = gltf::Sparse{1, 2, 0, gltf::ComponentType::uint8, 3, 0};
    gltf::Primitive primitive;
    primitive.attributes = {{"POSITION", 0}};
    primitive.indices = 1;
    primitive.targets = {{{"POSITION", 4}}};
    scene.meshes.push_back({"", {primitive}, {}});
    scene.nodes.resize(1);
    scene.nodes[0].mesh = 0;
    gltf::Image image;
    image.view = 5;
    scene.images.push_back(image);
    scene.animations.push_back({"", {{6, 7, gltf::Interpolation::linear}}, {}});
    gltf::Skin skin;
    skin.inverseBindMatrices = 8;
    scene.skins.push_back(skin);
    const ShownParts shown = shownParts(scene);
    for (uint32_t view = 0; view < 10; ++view) EXPECT_EQ(shown.views[view], view < 9) << view;
    scene.nodes[0].mesh = {};
    EXPECT_FALSE(shownParts(scene).views[0]);
    EXPECT_TRUE(shownParts(scene).views[5]) << "images count as shown";
}

}  // namespace
}  // namespace cleave::test
