// Files that must not be trusted: each is refused with one line that names the file, or survived with a warning.
#include <gtest/gtest.h>

#include <functional>

#include "scene/gltf_text.h"

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

TEST(GltfRefusal, knowsWhichExtensionsItMayIgnore) {
    auto required = [](const char* name) {
        return afterSpoiling([&](Document& d) { d.json["extensionsRequired"] = {name}; });
    };
    for (const char* name : {"KHR_mesh_quantization", "KHR_draco_mesh_compression", "EXT_meshopt_compression",
                             "KHR_meshopt_compression", "EXT_mesh_gpu_instancing", "KHR_materials_unlit",
                             "KHR_texture_transform", "KHR_lights_punctual", "KHR_materials_emissive_strength"})
        EXPECT_EQ(required(name), "");
    for (const char* name : {"KHR_draco", "ACME_magic", ""})
        EXPECT_NE(required(name).find("requires the extension " + std::string(name)), std::string::npos) << name;
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
