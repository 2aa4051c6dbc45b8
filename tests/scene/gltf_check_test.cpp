// What must hold of a document, whether the scene shows it or not; and what may be wrong with what is not used.
#include <gtest/gtest.h>

#include "gltf_text.h"

namespace cleave::test {
namespace {

// A triangle with a skin, a morph target, an animation, a texture, a camera and a light; none of them is shown, since
// the scene lists node 0 alone.
Document richDocument() {
    Document document = triangleDocument();
    const int joints = document.addAccessor(document.addView(std::string(12, '\0')), 5121, 3, "VEC4");
    const int weights = document.addAccessor(document.addView(std::string(48, '\0')), 5126, 3, "VEC4");
    const int matrices = document.addAccessor(document.addView(std::string(128, '\0')), 5126, 2, "MAT4");
    const int times = document.addAccessor(document.addView(bytesOf<float>({0, 1})), 5126, 2, "SCALAR");
    const int places = document.addAccessor(document.addView(std::string(72, '\0')), 5126, 6, "VEC3");
    const int turns = document.addAccessor(document.addView(std::string(32, '\0')), 5126, 2, "VEC4");
    const int scalars = document.addAccessor(document.addView(std::string(16, '\0')), 5126, 4, "SCALAR");
    document.json["materials"] =
        Json::parse(R"([{"normalTexture": {"index": 0}, "extensions": {"KHR_materials_clearcoat":
        {"clearcoatTexture": {"index": 0}}}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
        {"KHR_texture_transform": {"offset": [0, 0]}}}}}])");
    document.json["textures"] = Json::parse(R"([{"source": 0, "sampler": 0}])");
    document.json["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
    document.json["samplers"] = Json::parse(R"([{"magFilter": 9728}])");
    document.json["cameras"] = Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}])");
    document.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type": "spot", "spot": {}}])");
    document.json["skins"] = {{{"joints", {0, 1}}, {"inverseBindMatrices", matrices}, {"skeleton", 0}}};
    document.json["meshes"].push_back(
        {{"primitives",
          {{{"attributes", {{"POSITION", 0}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
            {"targets", {{{"POSITION", 0}}, {{"POSITION", 0}}}},
            {"material", 0}}}},
         {"weights", {0, 0}}});
    document.json["nodes"].push_back(Json::parse(R"({"mesh": 1, "skin": 0, "camera": 0, "weights": [0, 1],
        "extensions": {"KHR_lights_punctual": {"light": 0}}})"));
    const auto sampler = [&](int output, const char* interpolation) {
        return Json{{"input", times}, {"output", output}, {"interpolation", interpolation}};
    };
    const auto channel = [](int number, const char* path) {
        return Json{{"sampler", number}, {"target", {{"node", 1}, {"path", path}}}};
    };
    document.json["animations"] = {
        {{"samplers", {sampler(places, "CUBICSPLINE"), sampler(turns, "LINEAR"), sampler(scalars, "STEP")}},
         {"channels", {channel(0, "translation"), channel(1, "rotation"), channel(2, "weights")}}}};
    return document;
}

// Whether the scene shows it or not: each index, count and format is refused with where it is and what is wrong.
TEST(GltfCheck, refusesEveryWrongIndexCountAndFormat) {
    struct Case {
        const char* pointer;  // to what is spoiled
        const char* value;
        const char* message;
    };
    const std::vector<Case> cases = {
        {"/skins/0/joints/1", "99", "skins[0].joints[1] is 99, and there are 2 nodes"},
        {"/skins/0/joints/1", "-1", "skins[0].joints[1] is -1, and there are 2 nodes"},
        {"/skins/0/joints/1", "0.5", "skins[0].joints[1] is 0.5, and there are 2 nodes"},
        {"/skins/0/joints", "[]", "skins[0] has no joints"},
        {"/skins/0/joints", "7", "skins[0].joints is not an array"},
        {"/skins/0/skeleton", "2", "skins[0].skeleton is 2, and there are 2 nodes"},
        {"/skins/0/inverseBindMatrices", "8", "skins[0].inverseBindMatrices is 8, and there are 8 accessors"},
        {"/skins/0/inverseBindMatrices", "0", "skins[0].inverseBindMatrices is accessors[0], which holds \"VEC3\""},
        {"/accessors/3/count", "1", "skins[0].inverseBindMatrices has 1 matrices, and there are 2 joints"},
        {"/meshes/1/primitives/0/attributes/JOINTS_0", "8", "JOINTS_0 is 8, and there are 8 accessors"},
        {"/meshes/1/primitives/0/attributes/JOINTS_0", "2", "must hold VEC4 of integers of 8 or 16 bits without sign"},
        {"/meshes/1/primitives/0/attributes/WEIGHTS_0", "0", "must hold VEC4 of floats or of integers"},
        {"/meshes/1/primitives/0/attributes/TEXCOORD_0", "99", "attributes.TEXCOORD_0 is 99, and there are 8"},
        {"/accessors/1/count", "2", "attributes.POSITION has 3 elements, and the primitive has 2 vertices"},
        {"/meshes/1/primitives/0/targets/1/POSITION", "9", "targets[1].POSITION is 9, and there are 8 accessors"},
        {"/meshes/1/primitives/0/targets/1/POSITION", "1", "targets[1].POSITION is accessors[1], which holds \"VEC4\""},
        {"/meshes/1/primitives/0/targets/1/POSITION", "5", "has 6 elements, and the primitive has 3 vertices"},
        {"/meshes/1/primitives/0/targets/1", "3", "targets[1] is no object"},
        {"/meshes/1/primitives/0/material", "1", "primitives[0].material is 1, and there are 1 materials"},
        {"/meshes/1/weights", "[0]", "meshes[1].weights holds 1 numbers, and its mesh has 2 morph targets"},
        {"/nodes/1/weights", "[0,0,0]", "nodes[1].weights holds 3 numbers, and its mesh has 2 morph targets"},
        {"/nodes/1/weights", "[0,\"1\"]", "nodes[1].weights must hold 2 numbers"},
        {"/nodes/0/weights", "[1]", "nodes[0].weights holds 1 numbers, and its mesh has 0 morph targets"},
        {"/nodes/1/mesh", "2", "nodes[1].mesh is 2, and there are 2 meshes"},
        {"/nodes/1/skin", "1", "nodes[1].skin is 1, and there are 1 skins"},
        {"/nodes/1/camera", "1", "nodes[1].camera is 1, and there are 1 cameras"},
        {"/nodes/1/extensions/KHR_lights_punctual/light", "1", "light is 1, and there are 1 lights"},
        {"/nodes/1/extensions", R"({"EXT_mesh_gpu_instancing": {"attributes": {"SCALE": 8}}})",
         "SCALE is 8, and there are 8 accessors"},
        {"/nodes/1/extensions", R"({"EXT_mesh_gpu_instancing": {"attributes": {"_ID": 8}}})",
         "_ID is 8, and there are 8 accessors"},
        {"/nodes/1/extensions", R"({"EXT_mesh_gpu_instancing": {"attributes": {"ROTATION": 0}}})",
         "ROTATION is accessors[0], which holds \"VEC3\" of floats, and must hold VEC4 of floats or of integers"},
        {"/nodes/1/extensions", R"({"EXT_mesh_gpu_instancing": {"attributes": {"SCALE": 6}}})",
         "SCALE is accessors[6], which holds \"VEC4\" of floats, and must hold VEC3 of floats"},
        {"/nodes/1/extensions", R"({"EXT_mesh_gpu_instancing": {"attributes": {"_ID": 0, "TRANSLATION": 5}}})",
         "_ID has 3 elements, and the node has 6 instances"},
        {"/nodes/1/extensions", R"({"EXT_mesh_gpu_instancing": {"attributes": 1}})", "attributes is not an object"},
        {"/extensions/KHR_lights_punctual/lights/0/type", "\"sun\"", "lights[0].type is neither directional"},
        {"/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", "\"1\"", "outerConeAngle is \"1\""},
        {"/cameras/0/type", "\"flat\"", "cameras[0].type is neither perspective nor orthographic"},
        {"/cameras/0/perspective", "{}", "cameras[0].perspective has no yfov"},
        {"/cameras/0/perspective", "1", "cameras[0].perspective is not an object"},
        {"/animations/0/samplers/0/input", "8", "animations[0].samplers[0].input is 8, and there are 8 accessors"},
        {"/animations/0/samplers/0/output", "-2", "animations[0].samplers[0].output is -2"},
        {"/animations/0/samplers/0/input", "0", "animations[0].samplers[0].input is accessors[0], which holds"},
        {"/animations/0/samplers/1/output", "5", "must hold VEC4 of floats or of integers of 8 or 16 bits"},
        {"/animations/0/channels/1/target/path", "\"scale\"", "must hold VEC3 of floats"},
        {"/animations/0/samplers/0/interpolation", "\"STEP\"", "output holds 6 values, and 2 keys need 1 each"},
        {"/animations/0/samplers/1/interpolation", "\"CUBICSPLINE\"", "2 keys need a multiple of 6"},
        {"/animations/0/samplers/0/interpolation", "\"BEZIER\"", "interpolation is \"BEZIER\", which is not known"},
        {"/animations/0/channels/2/target/node", "0", "moves the weights of a node that has no morph targets"},
        {"/animations/0/channels/1/sampler", "3", "animations[0].channels[1].sampler is 3, and there are 3 samplers"},
        {"/animations/0/channels/1/target/node", "7", "channels[1].target.node is 7, and there are 2 nodes"},
        {"/animations/0/channels/1/target/path", "\"skew\"", "channels[1].target.path is \"skew\""},
        {"/animations/0/channels/1/target", "1", "animations[0].channels[1].target is not an object"},
        {"/accessors/4/count", "0", "animations[0].samplers[0].input holds no keys"},
        {"/textures/0/source", "1", "textures[0].source is 1, and there are 1 images"},
        {"/textures/0/sampler", "1", "textures[0].sampler is 1, and there are 1 samplers"},
        {"/textures/0/extensions", R"({"KHR_texture_basisu": {"source": 5}})", "source is 5, and there are 1 images"},
        {"/samplers/0/magFilter", "-1", "samplers[0].magFilter is -1"},
        {"/images/0/bufferView", "99", "images[0].bufferView is 99, and there are 8 bufferViews"},
        {"/images/0/mimeType", "3", "images[0].mimeType is not a string"},
        {"/images/0/uri", "\"x.png\"", "images[0] has both a uri and a bufferView"},
        {"/images/0", R"({"bufferView": 0})", "images[0] has a bufferView, and no mimeType"},
        {"/images/0", R"({"uri": ""})", "images[0].uri is empty"},
        {"/materials/0/normalTexture/index", "1", "materials[0].normalTexture.index is 1, and there are 1 textures"},
        {"/materials/0/normalTexture", "0", "materials[0].normalTexture is not an object"},
        {"/materials/0/normalTexture/texCoord", "-1", "materials[0].normalTexture.texCoord is -1"},
        {"/materials/0/pbrMetallicRoughness/baseColorTexture", "{}", "baseColorTexture has no index"},
        {"/materials/0/pbrMetallicRoughness/baseColorFactor", "[1]", "baseColorFactor must hold 4 numbers"},
        {"/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset", "[1]",
         "KHR_texture_transform.offset must hold 2 numbers"},
        {"/materials/0/extensions/KHR_materials_clearcoat/clearcoatTexture/index", "9",
         "clearcoatTexture.index is 9, and there are 1 textures"},
        {"/accessors/7/bufferView", "8", "accessors[7].bufferView is 8, and there are 8 bufferViews"},
        {"/accessors/7/count", "5", "accessors[7] has 5 elements, and its bufferView holds 4"},
        {"/accessors/7/componentType", "5124", "accessors[7].componentType is 5124, which is not known"},
        {"/accessors/7/sparse", R"({"count": 5, "indices": {}, "values": {}})", "accessors[7].sparse.count is 5"},
        {"/accessors/7/sparse", R"({"count": 2, "indices": {"bufferView": 1, "componentType": 5126}, "values": {}})",
         "accessors[7].sparse.indices are not integers without sign"},
        {"/accessors/7/sparse",
         R"({"count": 4, "indices": {"bufferView": 4, "componentType": 5123}, "values": {"bufferView": 4}})",
         "accessors[7].sparse.values has 4 elements, and its bufferView holds 2"},
        {"/bufferViews/7/buffer", "1", "bufferViews[7].buffer is 1, and there are 1 buffers"},
        {"/bufferViews/7/byteLength", "17", "past the end of buffers[0]"},
        {"/bufferViews/7/byteStride", "256", "bufferViews[7].byteStride is 256"},
        {"/bufferViews/7/byteStride", "6", "bufferViews[7].byteStride is 6, and must be a multiple of 4"},
    };
    ASSERT_EQ(refusal(richDocument()), "");
    for (const Case& each : cases) {
        Document document = richDocument();
        document.json[Json::json_pointer(each.pointer)] = Json::parse(each.value);
        const std::string message = refusal(document);
        EXPECT_NE(message.find(each.message), std::string::npos)
            << each.pointer << " = " << each.value << ": '" << message << "'";
        EXPECT_NE(message.find("scene.gltf"), std::string::npos) << message;
    }
}

// Images and animations are not decoded before they are used, so a buffer that only they need may be missing or short.
TEST(GltfCheck, warnsOfPayloadsThatAreMissingAndNotUsed) {
    Document document = triangleDocument();
    const int times = document.addAccessor(0, 5126, 1, "SCALAR");
    document.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 12}});
    document.json["accessors"].push_back({{"bufferView", 1}, {"componentType", 5126}, {"count", 1}, {"type", "VEC3"}});
    document.json["animations"] = Json::parse(R"([{"samplers": [{"input": 1, "output": 2}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}])");
    document.json["images"] = {{{"bufferView", 1}, {"mimeType", "image/png"}}};
    ASSERT_EQ(times, 1);
    document.json["buffers"] = {
        {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + base64(document.data)}}, {}};
    for (const char* uri : {"no such.bin", "data:application/octet-stream;base64,AAAA"}) {
        document.json["buffers"][1] = {{"byteLength", 12}, {"uri", uri}};
        const Scene scene = sceneOf(document);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_TRUE(mentions(scene.warnings, "buffers[1] is left out, with the images and animations that need it"));
        EXPECT_TRUE(pose(scene).warnings.empty());
        const PosedScene played = pose(scene, {0.0, {0}});
        EXPECT_EQ(played.triangles.size(), 1u);
        EXPECT_TRUE(mentions(played.warnings, "animation 0, channel 0 is left out: its keys are in a buffer"));
    }
    document.json["buffers"][1] = {{"byteLength", 12}, {"uri", "../outside.bin"}};
    EXPECT_NE(refusal(document).find("leaves the scene's folder"), std::string::npos);
}

TEST(GltfCheck, warnsOfNumbersThatStandForNothing) {
    Document document = richDocument();
    document.json["samplers"][0] = {{"magFilter", 9984}, {"wrapS", 1}};
    document.json["materials"][0]["alphaMode"] = "GLOW";
    const Scene scene = sceneOf(document);
    EXPECT_EQ(scene.samplers.at(0).magFilter, gltf::Filter::unspecified);
    EXPECT_EQ(scene.samplers[0].wrapS, gltf::Wrap::repeat);
    EXPECT_EQ(scene.materials.at(0).alphaMode, gltf::AlphaMode::opaque);
    for (const char* what : {"samplers[0].magFilter is 9984", "samplers[0].wrapS is 1", "materials[0].alphaMode"})
        EXPECT_TRUE(mentions(scene.warnings, what)) << what;
}

}  // namespace
}  // namespace cleave::test
