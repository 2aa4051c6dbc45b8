// Files that must not be trusted: each is refused with one line that names the file, or survived with a warning.
#include <gtest/gtest.h>

#include <functional>

#include "gltf_text.h"

namespace cleave::test {
namespace {

using Spoil = std::function<void(Document&)>;

std::string afterSpoiling(const Spoil& spoil) {
    Document document = triangleDocument();
    spoil(document);
    return refusal(document);
}

TEST(GltfRefusal, namesWhatIsWrongInOneLine) {
    const std::vector<std::pair<std::string, Spoil>> cases = {
        {"asset.version", [](Document& d) { d.json["asset"]["version"] = "1.0"; }},
        {"asset.version", [](Document& d) { d.json["asset"]["version"] = 2; }},
        {"asset.version", [](Document& d) { d.json["asset"].erase("version"); }},
        {"asset.minVersion", [](Document& d) { d.json["asset"]["minVersion"] = "2.1"; }},
        {"'asset'", [](Document& d) { d.json.erase("asset"); }},
        {"nodes[0].mesh is -1", [](Document& d) { d.node()["mesh"] = -1; }},
        {"nodes[0].mesh is 1", [](Document& d) { d.node()["mesh"] = 1; }},
        {"nodes[0].mesh is 4294967296", [](Document& d) { d.node()["mesh"] = uint64_t(1) << 32; }},
        {"nodes[0].mesh is 0.5", [](Document& d) { d.node()["mesh"] = 0.5; }},
        {"nodes[0].camera", [](Document& d) { d.node()["camera"] = 0; }},
        {"nodes[0].skin", [](Document& d) { d.node()["skin"] = 0; }},
        {"nodes[0].children", [](Document& d) { d.node()["children"] = {1}; }},
        {"cycle", [](Document& d) { d.node()["children"] = {0}; }},
        {"cycle",
         [](Document& d) { d.json["nodes"] = Json::parse(R"([{"mesh": 0}, {"children": [2]}, {"children": [1]}])"); }},
        {"child of two",
         [](Document& d) { d.json["nodes"] = Json::parse(R"([{"children": [2]}, {"children": [2]}, {}])"); }},
        {"child of two", [](Document& d) { d.json["nodes"] = Json::parse(R"([{"children": [1, 1]}, {}])"); }},
        {"not a root", [](Document& d) { d.json.update(Json::parse(R"({"nodes": [{}, {"children": [0]}]})")); }},
        {"twice",
         [](Document& d) {
             d.json["scenes"][0]["nodes"] = {0, 0};
         }},
        {"scenes[0].nodes", [](Document& d) { d.json["scenes"][0]["nodes"] = {-1}; }},
        {"default scene", [](Document& d) { d.json["scene"] = 1; }},
        {"nodes[0].matrix",
         [](Document& d) {
             d.node()["matrix"] = {1, 2, 3};
         }},
        {"nodes[0].rotation",
         [](Document& d) {
             d.node()["rotation"] = {0, 0, 0, "1"};
         }},
        {"POSITION is 7", [](Document& d) { d.primitive()["attributes"]["POSITION"] = 7; }},
        {"indices is -1", [](Document& d) { d.primitive()["indices"] = -1; }},
        {"material is 0", [](Document& d) { d.primitive()["material"] = 0; }},
        {"mode", [](Document& d) { d.primitive()["mode"] = 7; }},
        {"attributes", [](Document& d) { d.primitive().erase("attributes"); }},
        {"accessors[0].bufferView", [](Document& d) { d.json["accessors"][0]["bufferView"] = -1; }},
        {"accessors[0] has no count", [](Document& d) { d.json["accessors"][0].erase("count"); }},
        {"componentType", [](Document& d) { d.json["accessors"][0]["componentType"] = 1; }},
        {"bufferViews[0].buffer", [](Document& d) { d.json["bufferViews"][0]["buffer"] = 1; }},
        {"bufferViews[0] has no buffer", [](Document& d) { d.json["bufferViews"][0].erase("buffer"); }},
        {"bufferViews[0].byteStride is 13", [](Document& d) { d.json["bufferViews"][0]["byteStride"] = 13; }},
        {"nodes is not an array", [](Document& d) { d.json["nodes"] = 3; }},
        {"no object", [](Document& d) { d.json["meshes"] = {3}; }},
    };
    for (const auto& [part, spoil] : cases) {
        const std::string message = afterSpoiling(spoil);
        EXPECT_NE(message.find(part), std::string::npos) << part << ": '" << message << "'";
        EXPECT_NE(message.find("scene.gltf"), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

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
TEST(GltfRefusal, checksEveryIndexCountAndFormat) {
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

// What would need decoding only if it were used is none of the checks' business.
TEST(GltfRefusal, warnsOfPayloadsThatAreNotUsed) {
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

TEST(GltfRefusal, warnsOfNumbersThatStandForNothing) {
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

TEST(GltfRefusal, knowsWhichExtensionsItMayIgnore) {
    auto required = [](const char* name) {
        return afterSpoiling([&](Document& d) { d.json["extensionsRequired"] = {name}; });
    };
    for (const char* name : {"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_transform",
                             "KHR_lights_punctual", "KHR_materials_emissive_strength"})
        EXPECT_EQ(required(name), "");
    for (const char* name :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing", "ACME_magic", ""})
        EXPECT_NE(required(name).find("requires the extension " + std::string(name)), std::string::npos) << name;
}

TEST(GltfRefusal, doesNotReadDracoAsZeros) {
    const std::string message = afterSpoiling([](Document& d) {
        d.primitive()["extensions"] = {{"KHR_draco_mesh_compression", {{"bufferView", 0}}}};
        d.json["accessors"][0].erase("bufferView");
    });
    EXPECT_NE(message.find("KHR_draco_mesh_compression"), std::string::npos);
}

TEST(GltfRefusal, boundsTheNestingOfJson) {
    Document document = triangleDocument();
    std::string deep;
    for (int i = 0; i < 200000; ++i) deep += '[';
    std::string text = document.text();
    text.insert(text.size() - 1, ",\"extras\":" + deep + std::string(deep.size(), ']'));
    EXPECT_NE(refusal(text).find("nested"), std::string::npos);
    EXPECT_NE(refusal("{\"asset\":").find("JSON"), std::string::npos);
    EXPECT_NE(refusal("[]").find("not an object"), std::string::npos);
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
}

TEST(GltfRefusal, readsGlbByItsBytes) {
    const Document document = triangleDocument();
    const std::string good = document.glb();
    EXPECT_EQ(loadText(good, "scene.glb").triangles.at(0).b, vec3(1, 0, 0));
    EXPECT_EQ(loadText(good, "scene.gltf").triangles.size(), 1u);  // by content, not by name
    for (size_t size = 0; size < good.size(); ++size)
        EXPECT_NE(refusal(good.substr(0, size), "scene.glb"), "") << size << " of " << good.size() << " bytes";
    std::string version = good;
    version[4] = 1;
    EXPECT_NE(refusal(version, "scene.glb").find("version 1"), std::string::npos);
    std::string huge = good;
    std::memset(huge.data() + 12, 0xFF, 4);
    EXPECT_NE(refusal(huge, "scene.glb").find("chunk"), std::string::npos);
    EXPECT_NE(refusal(document.text(), "scene.glb").find("'glTF'"), std::string::npos);
}

// A triangle whose buffer is the file `uri`; `files` are written beside it.
std::string withBufferUri(const std::string& uri, size_t size = 36) {
    Document document = triangleDocument();
    document.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    const Folder folder;
    folder.write("outside.bin", document.data);
    folder.write("in/sub/good one.bin", document.data.substr(0, size));
    std::filesystem::create_symlink(folder.path() / "outside.bin", folder.path() / "in/link.bin");
    try {
        loadGltf(folder.write("in/scene.gltf", document.text()));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(GltfUri, staysInTheFolderOfTheScene) {
    for (const char* uri :
         {"sub/good%20one.bin", "sub/good one.bin", "./sub/../sub/good%20one.bin", "sub\\good%20one.bin"})
        EXPECT_EQ(withBufferUri(uri), "") << uri;
    for (const char* uri : {"../outside.bin", "sub/../../outside.bin", "%2e%2e/outside.bin", "..%2Foutside.bin",
                            "..\\outside.bin", "%2e%2e%5Coutside.bin", "/etc/passwd", "%2Fetc/passwd", "link.bin", "",
                            "file:///etc/passwd", "FILE:x", "http://example.com/x.bin", "http%3A//example.com/x.bin",
                            "C:\\x.bin", "\\\\server\\x.bin", "sub/good%20one.bin%00.png"}) {
        const std::string message = withBufferUri(uri);
        EXPECT_NE(message.find("relative path"), std::string::npos) << uri << ": " << message;
        EXPECT_NE(message.find("URI"), std::string::npos) << uri << ": " << message;
    }
}

TEST(GltfUri, refusesBuffersThatAreMissingOrShort) {
    EXPECT_NE(withBufferUri("no.bin").find("there is no file"), std::string::npos);
    EXPECT_NE(withBufferUri("sub").find("not a regular file"), std::string::npos);
    EXPECT_NE(withBufferUri("sub/good%20one.bin", 35).find("35 bytes"), std::string::npos);
    EXPECT_NE(withBufferUri("data:application/octet-stream;base64,AAAA").find("3 bytes"), std::string::npos);
    EXPECT_NE(withBufferUri("data:application/octet-stream;base64,").find("decoded"), std::string::npos);
    EXPECT_NE(withBufferUri("data:nonsense,AAAA").find("decoded"), std::string::npos);
}

TEST(GltfUri, imagesMayBeMissingButMayNotEscape) {
    Document document = triangleDocument();
    document.json["images"] = {{{"uri", "no such.png"}}, {{"uri", "data:image/png;base64,??"}}};
    const PosedScene scene = load(document);
    EXPECT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(mentions(scene.warnings, "no such.png"));
    for (const char* uri : {"../x.png", "http://example.com/x.png", "file:x.png"}) {
        document.json["images"] = {{{"uri", uri}}};
        EXPECT_NE(refusal(document).find("relative path"), std::string::npos) << uri;
    }
}

TEST(GltfUri, anUnusedBufferIsNotRead) {
    Document document = triangleDocument();
    const std::string own = "data:application/octet-stream;base64," + base64(document.data);
    auto withSecond = [&](const char* uri) {
        document.json["buffers"] = {{{"byteLength", 36}, {"uri", own}}, {{"byteLength", 4}, {"uri", uri}}};
        return refusal(document);
    };
    EXPECT_EQ(withSecond("missing.bin"), "");
    EXPECT_EQ(withSecond("http://example.com/x.bin"), "");
    EXPECT_NE(withSecond("../x.bin"), "");
}

TEST(GltfUri, leavesOutGeometryWhoseBufferIsNowhere) {
    Document document = triangleDocument();
    document.json["buffers"] = {{{"byteLength", 36}}};
    PosedScene scene = load(document);
    EXPECT_TRUE(scene.triangles.empty());
    EXPECT_EQ(scene.leftOut["primitivesWithoutData"], 1u);
    EXPECT_EQ(scene.warnings.size(), 1u);
}

// Nodes times primitives, each with the node's name: far more text than the file, were it all kept.
TEST(GltfRefusal, warningsStayFewAndShort) {
    Document document = triangleDocument();
    document.json["meshes"][0]["primitives"] = Json(50, Json{{"attributes", Json::object()}});
    document.json["nodes"] = Json(40, Json{{"mesh", 0}, {"name", std::string(30000, 'n') + "\n"}});
    document.json.erase("scenes");
    document.json.erase("scene");
    const PosedScene scene = load(document);
    EXPECT_EQ(scene.leftOut.at("primitivesWithoutPosition"), 2000u);
    ASSERT_EQ(scene.warnings.size(), 21u);
    EXPECT_NE(scene.warnings.back().find("1980 more"), std::string::npos) << scene.warnings.back();
    for (const std::string& warning : scene.warnings) {
        EXPECT_LT(warning.size(), 300u);
        EXPECT_EQ(warning.find('\n'), std::string::npos);
    }
}

TEST(GltfRefusal, boundsTheTriangles) {
    const std::string text = triangleDocument().text();
    const std::vector<unsigned char> bytes(text.begin(), text.end());
    const Scene scene = loadGltf("scene.gltf", bytes, 1);
    EXPECT_EQ(pose(scene, {}, 1).triangles.size(), 1u);
    EXPECT_THROW(loadGltf("scene.gltf", bytes, 0), Error);
    EXPECT_THROW(pose(scene, {}, 0), Error);
    // 300 bytes that ask for gigabytes: positions without a bufferView are zeros.
    Document zeros;
    zeros.addMesh(zeros.addAccessor(-1, 5126, 3 * (kMostTriangles + 1), "VEC3"));
    EXPECT_NE(refusal(zeros).find("more than"), std::string::npos);
}

TEST(GltfRefusal, saysThatAFileIsMissing) {
    try {
        loadGltf("/no/such/scene.glb");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("there is no file"), std::string::npos);
    }
}

}  // namespace
}  // namespace cleave::test
