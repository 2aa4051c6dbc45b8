// EXT_meshopt_compression: a compressed bufferView is what the plain one would be, or is refused.
#include <gtest/gtest.h>

#include "compressed.h"
#include "moving_triangle.h"
#include "scene/accessor_view.h"

namespace cleave::test {
namespace {

TEST(Meshopt, attributesAndTrianglesAreThoseOfThePlainFile) {
    for (const uint32_t n : {1u, 3u, 40u}) {
        const PosedScene plain = load(plainGrid(n));
        const PosedScene compressed = load(meshoptGrid(n));
        EXPECT_EQ(plain.triangles.size(), size_t(2) * n * n);
        EXPECT_EQ(sortedTriangles(compressed), sortedTriangles(plain));
        EXPECT_TRUE(compressed.warnings.empty());
    }
}

// Integers of 16 bits in elements of 8 bytes, by both kinds of indices, of both sizes.
TEST(Meshopt, readsQuantizedStridedAndStrippedData) {
    const std::vector<uint16_t> corners = {0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9, 1, 1, 0, 9, 2, 0, 0, 9};
    const std::vector<uint32_t> strip = {0, 2, 1, 3, 4};
    const std::vector<uint32_t> list = {0, 2, 1, 2, 3, 1};
    const auto add = [&](Document& document, int positions, int indices, size_t count, size_t size, int mode) {
        document.addMesh(document.addAccessor(positions, 5123, 5, "VEC3"),
                         document.addAccessor(indices, size == 2 ? 5123 : 5125, count, "SCALAR"), {{"mode", mode}});
    };
    const auto narrow = [](const std::vector<uint32_t>& wide) {
        return bytesOf(std::vector<uint16_t>(wide.begin(), wide.end()));
    };
    for (const size_t size : {2u, 4u}) {
        Document twin;
        Document compressed;
        const int plain = twin.addView(bytesOf(corners), 8);
        const int plainStrip = twin.addView(size == 2 ? narrow(strip) : bytesOf(strip));
        const int plainList = twin.addView(size == 2 ? narrow(list) : bytesOf(list));
        add(twin, plain, plainStrip, 5, size, 5);
        add(twin, plain, plainList, 6, size, 4);
        const int coded =
            addMeshoptView(compressed, meshoptAttributes(bytesOf(corners), 8), 5, 8, "ATTRIBUTES", "NONE");
        const int codedStrip = addMeshoptView(compressed, meshoptIndices(strip), 5, size, "INDICES");
        const int codedList = addMeshoptView(compressed, meshoptTriangles(list), 6, size, "TRIANGLES");
        add(compressed, coded, codedStrip, 5, size, 5);
        add(compressed, coded, codedList, 6, size, 4);
        for (Document* document : {&twin, &compressed}) document->json["scenes"][0]["nodes"] = {0, 1};
        const PosedScene scene = load(withFallback(compressed));
        EXPECT_EQ(scene.triangles.size(), 5u);
        EXPECT_EQ(sortedTriangles(scene), sortedTriangles(load(twin)));
    }
}

// What the extension's filters make of data that is known: the oracle is the data before it was filtered.
TEST(Meshopt, appliesFilters) {
    const Floats places = {0, 0, 0, 1, -2.5f, 1024, 0.125f, 3, -7};
    std::vector<uint32_t> coded(places.size());
    meshopt_encodeFilterExp(coded.data(), 3, 12, 24, places.data());
    Document document;
    const int view =
        addMeshoptView(document, meshoptAttributes(bytesOf(coded), 12), 3, 12, "ATTRIBUTES", "EXPONENTIAL");
    document.addMesh(document.addAccessor(view, 5126, 3, "VEC3"));
    const PosedScene scene = load(withFallback(document));
    ASSERT_EQ(scene.triangles.size(), 1u);
    const Triangle& t = scene.triangles[0];
    EXPECT_EQ((Floats{t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}), places);
}

TEST(Meshopt, appliesTheFilterOfRotations) {
    const Floats turns = {0,    0,    0,     1, 0.5f, 0.5f, -0.5f, 0.5f, 0,     0,
                          0.6f, 0.8f, -0.8f, 0, 0.6f, 0,    0.1f,  0.7f, -0.1f, 0.7f};
    std::vector<uint16_t> coded(turns.size());
    meshopt_encodeFilterQuat(coded.data(), 5, 8, 16, turns.data());
    Document document = triangleDocument();
    const int view = addMeshoptView(document, meshoptAttributes(bytesOf(coded), 8), 5, 8, "ATTRIBUTES", "QUATERNION");
    const int accessor = document.addAccessor(view, 5122, 5, "VEC4", {{"normalized", true}});
    document.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"ROTATION", accessor}};
    const Scene scene = sceneOf(withFallback(document));
    const AccessorValues values(scene, uint32_t(accessor));
    ASSERT_EQ(values.count(), 5u);
    for (size_t i = 0; i < 5; ++i) {
        const glm::dvec4 expected(turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]);
        const glm::dvec4 got = values.vec4(i);  // or its opposite, which is the same rotation
        EXPECT_NEAR(std::abs(glm::dot(got, expected)) / glm::length(expected), 1.0, 1e-4) << i;
    }
    EXPECT_EQ(pose(scene).triangles.size(), 5u);
}

TEST(Meshopt, appliesTheFilterOfUnitVectors) {
    const Floats normals = {0, 0, 1, 0, 0.6f, -0.8f, 0, 0, -0.36f, 0.48f, -0.8f, 0, 0, 0, -1, 0, -1, 0, 0, 0};
    for (const size_t stride : {4u, 8u}) {
        std::string coded(5 * stride, '\0');
        meshopt_encodeFilterOct(coded.data(), 5, stride, stride == 4 ? 8 : 16, normals.data());
        Document document = triangleDocument();
        const int view =
            addMeshoptView(document, meshoptAttributes(coded, stride), 5, stride, "ATTRIBUTES", "OCTAHEDRAL");
        const int accessor = document.addAccessor(view, stride == 4 ? 5120 : 5122, 5, "VEC3", {{"normalized", true}});
        const Scene scene = sceneOf(withFallback(document).text(), "scene.gltf", Reading::everything);
        const AccessorValues values(scene, uint32_t(accessor));
        for (size_t i = 0; i < 5; ++i)
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(values.vec3(i)[k], normals[4 * i + size_t(k)], stride == 4 ? 0.02 : 1e-4) << i << " " << k;
    }
}

TEST(Meshopt, hasTwoNames) {
    Document document = meshoptGrid(3);
    for (Json& view : document.json["bufferViews"]) {
        view["extensions"]["KHR_meshopt_compression"] = view["extensions"]["EXT_meshopt_compression"];
        view["extensions"].erase("EXT_meshopt_compression");
    }
    document.json["extensionsRequired"] = {"KHR_meshopt_compression"};
    EXPECT_EQ(sortedTriangles(load(document)), sortedTriangles(load(plainGrid(3))));
}

// What is not compressed may be there too. It is not read.
TEST(Meshopt, doesNotReadTheFallback) {
    Document document = meshoptGrid(3);
    document.json["buffers"][1]["uri"] = "no such file.bin";
    EXPECT_EQ(refusal(document), "");
    document.json["buffers"][0].erase("uri");  // and what is compressed may be missing
    PosedScene scene = load(document);
    EXPECT_EQ(scene.leftOut["primitivesWithoutData"], 1u);
    EXPECT_TRUE(mentions(scene.warnings, "its data is in a buffer that has no URI"));
}

TEST(Meshopt, refusesWhatTheExtensionDoesNotAllow) {
    struct Case {
        const char* member;
        Json value;
        const char* message;
        size_t view = 0;
    };
    const std::vector<Case> cases = {
        {"buffer", 2, ".buffer is 2, and there are 2 buffers"},
        {"buffer", 1, ".buffer is 1, which is a fallback for uncompressed data"},
        {"buffer", nullptr, "has no buffer"},
        {"byteOffset", 1 << 20, "past the end of buffers[0]"},
        {"byteLength", uint64_t(1) << 48, "past the end of buffers[0]"},
        {"byteLength", uint64_t(1) << 60, "byteLength is"},
        {"byteLength", nullptr, "has no byteLength"},
        {"mode", "VERTICES", ".mode is \"VERTICES\", which is not supported"},
        {"mode", 3, ".mode is 3"},
        {"mode", nullptr, "has no mode"},
        {"mode", "TRIANGLES", ".byteStride is 12, which its mode and filter do not allow"},
        {"filter", "COLOR", ".filter is \"COLOR\", which is not supported"},
        {"filter", 0, ".filter is 0"},
        {"filter", "OCTAHEDRAL", ".byteStride is 12, which its mode and filter do not allow"},
        {"filter", "QUATERNION", ".byteStride is 12, which its mode and filter do not allow"},
        {"filter", "EXPONENTIAL", ".filter is \"EXPONENTIAL\", and there is none for indices", 1},
        {"byteStride", 0, ".byteStride is 0"},
        {"byteStride", 6, ".byteStride is 6"},
        {"byteStride", 260, ".byteStride is 260"},
        {"byteStride", 8, ".byteStride is 8, and that of its bufferView is 12"},
        {"byteStride", nullptr, "has no byteStride"},
        {"count", 15, "makes 180 bytes, and its bufferView has 192"},
        {"count", 53, ".count is 53, and must be a multiple of 3", 1},
        {"count", -3, ".count is -3"},
        {"count", nullptr, "has no count"},
    };
    ASSERT_EQ(refusal(meshoptGrid(3)), "");
    for (const Case& each : cases) {
        Document document = meshoptGrid(3);
        Json& meshopt = document.json["bufferViews"][each.view]["extensions"]["EXT_meshopt_compression"];
        if (each.value.is_null())
            meshopt.erase(each.member);
        else
            meshopt[each.member] = each.value;
        const std::string message = refusal(document);
        EXPECT_NE(message.find(each.message), std::string::npos) << each.message << ": '" << message << "'";
    }
    Document document = meshoptGrid(3);
    document.json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"] = 1;
    EXPECT_NE(refusal(document).find("fallback is neither true nor false"), std::string::npos);
}

// A small file may announce any size; nothing of that size is allocated.
TEST(Meshopt, boundsWhatDataMayBecome) {
    Document document = meshoptGrid(3);
    const uint64_t count = uint64_t(1) << 40;
    Json& view = document.json["bufferViews"][0];
    view["byteLength"] = 12 * count;
    view["extensions"]["EXT_meshopt_compression"]["count"] = count;
    document.json["buffers"][1]["byteLength"] = 12 * count;
    EXPECT_NE(refusal(document).find("bufferViews[0] cannot become 13194139533312 bytes"), std::string::npos);

    // Many views of the same bytes: each is possible, and all are too much.
    Document many = meshoptGrid(40);
    for (int i = 0; i < 100; ++i) many.json["bufferViews"].push_back(many.json["bufferViews"][0]);
    const std::string text = many.text();
    const std::vector<unsigned char> bytes(text.begin(), text.end());
    EXPECT_NO_THROW(loadGltf("scene.gltf", bytes, 3200)) << "nothing shows them";
    EXPECT_NO_THROW(loadGltf("scene.gltf", bytes, 1 << 15, Reading::everything));
    try {
        loadGltf("scene.gltf", bytes, 3200, Reading::everything);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("is the most that is left for the scene"), std::string::npos);
    }
}

// Whatever the bytes are: a scene, or a sentence.
TEST(Meshopt, survivesSpoiltBytes) {
    constexpr unsigned kSeed = 1;
    std::minstd_rand random(kSeed);
    const Document good = meshoptGrid(9);
    size_t refused = 0;
    for (int i = 0; i < 500; ++i) {
        Document document = good;
        spoilBytes(document.data, random);
        const std::string message = refusal(withFallback(document));
        EXPECT_EQ(message.find('\n'), std::string::npos) << "seed " << kSeed << ", round " << i;
        refused += message.empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 0u);
    for (size_t view = 0; view < 2; ++view) {
        Document document = good;
        Json& meshopt = document.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
        meshopt["byteLength"] = meshopt["byteLength"].get<size_t>() - 1;
        EXPECT_NE(refusal(document).find("cannot be decompressed by meshopt"), std::string::npos);
    }
}

}  // namespace
}  // namespace cleave::test
