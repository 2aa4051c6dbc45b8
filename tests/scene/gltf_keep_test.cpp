// What a scene keeps of a document that nothing here draws.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gltf_text.h"

namespace cleave::test {
namespace {

TEST(GltfKeep, materialsWithAllFactorsAndTextures) {
    Document document = triangleDocument();
    document.json["images"] = {{{"uri", "data:image/png;base64,AAAA"}},
                               {{"bufferView", 0}, {"mimeType", "image/jpeg"}, {"name", "wood"}}};
    document.json["samplers"] =
        Json::parse(R"([{"magFilter": 9728, "minFilter": 9987, "wrapS": 33071, "wrapT": 33648}])");
    document.json["textures"] = Json::parse(R"([{"source": 1, "sampler": 0, "name": "oak"}, {}])");
    document.json["materials"] = Json::parse(R"([{
        "pbrMetallicRoughness": {"metallicFactor": 0.25, "roughnessFactor": 0.5,
            "baseColorTexture": {"index": 0, "texCoord": 1, "extensions": {"KHR_texture_transform":
                {"offset": [1, 2], "rotation": 3, "scale": [4, 5], "texCoord": 6}}},
            "metallicRoughnessTexture": {"index": 1}},
        "normalTexture": {"index": 1, "scale": 0.75}, "occlusionTexture": {"index": 0, "strength": 0.5},
        "emissiveTexture": {"index": 1, "texCoord": 2}, "emissiveFactor": [0.25, 0.5, 1],
        "alphaMode": "MASK", "alphaCutoff": 0.125, "doubleSided": true,
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}, "KHR_materials_unlit": {}}}])");
    const Scene scene = sceneOf(document);
    const gltf::Material& m = scene.materials.at(0);
    EXPECT_EQ(m.metallic, 0.25f);
    EXPECT_EQ(m.roughness, 0.5f);
    EXPECT_EQ(m.normalScale, 0.75f);
    EXPECT_EQ(m.occlusionStrength, 0.5f);
    EXPECT_EQ(m.emissive, glm::vec3(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(m.emissiveStrength, 8.0f);
    EXPECT_EQ(m.alphaMode, gltf::AlphaMode::mask);
    EXPECT_EQ(m.alphaCutoff, 0.125f);
    EXPECT_TRUE(m.doubleSided);
    EXPECT_TRUE(m.unlit);
    ASSERT_TRUE(m.baseColourTexture && m.metallicRoughnessTexture && m.normalTexture && m.occlusionTexture);
    EXPECT_EQ(m.baseColourTexture->texture, 0u);
    EXPECT_EQ(m.baseColourTexture->texCoord, 6u);
    EXPECT_EQ(m.baseColourTexture->offset, glm::dvec2(1, 2));
    EXPECT_EQ(m.baseColourTexture->rotation, 3.0);
    EXPECT_EQ(m.baseColourTexture->scale, glm::dvec2(4, 5));
    EXPECT_EQ(m.metallicRoughnessTexture->texture, 1u);
    EXPECT_EQ(m.emissiveTexture.value().texCoord, 2u);
    EXPECT_EQ(scene.textures.at(0).image, gltf::Index(1));
    EXPECT_EQ(scene.textures[0].sampler, gltf::Index(0));
    EXPECT_FALSE(scene.textures[1].image);
    EXPECT_EQ(scene.samplers.at(0).minFilter, gltf::Filter::linearMipmapLinear);
    EXPECT_EQ(scene.samplers[0].wrapT, gltf::Wrap::mirroredRepeat);
    EXPECT_EQ(scene.images.at(0).uri, "data:image/png;base64,AAAA");
    EXPECT_EQ(scene.images.at(1).view, gltf::Index(0));
    EXPECT_EQ(scene.images[1].mimeType, "image/jpeg");
    const gltf::Material& plain = scene.materials.at(1);
    EXPECT_EQ(plain.name, "default");
    EXPECT_EQ(plain.metallic, 1.0f);
    EXPECT_FALSE(plain.baseColourTexture || plain.doubleSided || plain.unlit);
}

// Values outside of what glTF allows are brought to its ends: no renderer meets them.
TEST(GltfKeep, bringsFactorsIntoTheirRanges) {
    Document document = triangleDocument();
    document.json["textures"] = {Json::object()};
    document.json["materials"] = Json::parse(R"([
        {"pbrMetallicRoughness": {"baseColorFactor": [-1, 2, 1e300, 0.5], "metallicFactor": 7, "roughnessFactor": -1},
         "normalTexture": {"index": 0, "scale": -1e300}, "occlusionTexture": {"index": 0, "strength": 1.5},
         "emissiveFactor": [-1, 0.5, 1e300], "alphaCutoff": -0.5,
         "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 1e300}}}])");
    document.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([
        {"type": "spot", "color": [-1, 0.5, 3], "intensity": -5, "range": 0,
         "spot": {"innerConeAngle": 9, "outerConeAngle": 3}}])");
    const Scene scene = sceneOf(document);
    const gltf::Material& m = scene.materials.at(0);
    EXPECT_EQ(m.baseColour, glm::vec4(0.0f, 1.0f, 1.0f, 0.5f));
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 0.0f);
    EXPECT_EQ(m.normalScale, -std::numeric_limits<float>::max());
    EXPECT_EQ(m.occlusionStrength, 1.0f);
    EXPECT_EQ(m.emissive, glm::vec3(0.0f, 0.5f, 1.0f));
    EXPECT_EQ(m.emissiveStrength, std::numeric_limits<float>::max());
    EXPECT_EQ(m.alphaCutoff, 0.0f);
    const gltf::Light& light = scene.lights.at(0);
    EXPECT_EQ(light.colour, glm::dvec3(0.0, 0.5, 3.0));
    EXPECT_EQ(light.intensity, 0.0);
    EXPECT_TRUE(std::isinf(light.range));
    EXPECT_NEAR(light.outerConeAngle, 1.5707963, 1e-7);
    EXPECT_EQ(light.innerConeAngle, light.outerConeAngle);
}

TEST(GltfKeep, nodesApartFromTheirMeshes) {
    Document document = triangleDocument();
    document.json["nodes"].push_back(
        Json::parse(R"({"mesh": 0, "name": "second", "scale": [1, 2, 3], "children": [2]})"));
    document.json["nodes"].push_back(Json::parse(R"({"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 7,8,9,1]})"));
    document.json["scenes"].push_back({{"nodes", {1}}, {"name", "other"}});
    const Scene scene = sceneOf(document);
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_EQ(scene.nodes[1].mesh, scene.nodes[0].mesh);
    EXPECT_EQ(scene.nodes[1].transform.scale, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.nodes[1].children, std::vector<uint32_t>{2});
    EXPECT_EQ(scene.nodes[2].transform.matrix.value()[3], glm::dvec4(7, 8, 9, 1));
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.scenes.at(1).name, "other");
    EXPECT_EQ(scene.defaultScene, gltf::Index(0));
}

}  // namespace
}  // namespace cleave::test
