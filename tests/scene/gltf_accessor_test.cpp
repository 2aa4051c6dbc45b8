// Where the numbers of an accessor come from, and which accessors are refused.
#include <gtest/gtest.h>

#include "scene/gltf_text.h"

namespace cleave::test {
namespace {

vec3 lastVertex(const PosedScene& scene) { return scene.triangles.at(0).c; }

// One triangle whose third vertex has the given components, in integers.
template <typename Integer>
vec3 quantized(int componentType, bool normalized, Integer x, Integer y, Integer z) {
    const Integer o = 0;
    const Integer p = 1;
    const size_t stride = sizeof(Integer) == 1 ? 4 : 8;  // vertices are aligned to four bytes
    std::string bytes;
    for (const auto& vertex : {std::vector<Integer>{o, o, o, o}, {p, o, o, o}, {x, y, z, o}}) bytes += bytesOf(vertex);
    Document document;
    document.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int view = document.addView(bytes, int(stride));
    document.addMesh(document.addAccessor(view, componentType, 3, "VEC3", {{"normalized", normalized}}));
    return lastVertex(load(document));
}

TEST(GltfAccessor, readsQuantizedPositions) {
    EXPECT_EQ(quantized<int8_t>(5120, false, -128, 5, 127), vec3(-128, 5, 127));
    EXPECT_EQ(quantized<uint8_t>(5121, false, 0, 5, 255), vec3(0, 5, 255));
    EXPECT_EQ(quantized<int16_t>(5122, false, -32768, 5, 32767), vec3(-32768, 5, 32767));
    EXPECT_EQ(quantized<uint16_t>(5123, false, 0, 5, 65535), vec3(0, 5, 65535));
}

TEST(GltfAccessor, normalisesAndClampsTheLowest) {
    EXPECT_EQ(quantized<int8_t>(5120, true, -128, -127, 64), vec3(-1, -1, float(64.0 / 127.0)));
    EXPECT_EQ(quantized<uint8_t>(5121, true, 0, 51, 255), vec3(0, 0.2f, 1));
    EXPECT_EQ(quantized<int16_t>(5122, true, -32768, -32767, 1), vec3(-1, -1, float(1.0 / 32767.0)));
    EXPECT_EQ(quantized<uint16_t>(5123, true, 0, 13107, 65535), vec3(0, 0.2f, 1));
}

TEST(GltfAccessor, followsOffsetAndStride) {
    // Per vertex: position, then two floats of something else; the accessor starts four bytes in.
    Document document;
    const int view = document.addView(bytesOf<float>({99, 0, 0, 0, 7, 7, 1, 0, 0, 7, 7, 0, 2, 3}), 20);
    document.addMesh(document.addAccessor(view, 5126, 3, "VEC3", {{"byteOffset", 4}}));
    const PosedScene scene = load(document);
    EXPECT_EQ(scene.triangles[0].b, vec3(1, 0, 0));
    EXPECT_EQ(scene.triangles[0].c, vec3(0, 2, 3));
}

Json sparse(int indexView, int indexType, int valueView, int count) {
    return {{"sparse",
             {{"count", count},
              {"indices", {{"bufferView", indexView}, {"componentType", indexType}}},
              {"values", {{"bufferView", valueView}}}}}};
}

TEST(GltfAccessor, substitutesSparseValues) {
    Document document;
    const int base = document.addView(bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const int indices = document.addView(bytesOf<uint16_t>({0, 2}));
    const int values = document.addView(bytesOf<float>({5, 5, 5, 6, 6, 6}));
    document.addMesh(document.addAccessor(base, 5126, 3, "VEC3", sparse(indices, 5123, values, 2)));
    const PosedScene scene = load(document);
    EXPECT_EQ(scene.triangles[0].a, vec3(5));
    EXPECT_EQ(scene.triangles[0].b, vec3(1, 0, 0));
    EXPECT_EQ(scene.triangles[0].c, vec3(6));
}

TEST(GltfAccessor, fillsWithZerosWithoutABufferView) {
    Document document;
    const int indices = document.addView(bytesOf<uint8_t>({1}));
    const int values = document.addView(bytesOf<float>({3, 4, 5}));
    document.addMesh(document.addAccessor(-1, 5126, 3, "VEC3", sparse(indices, 5121, values, 1)));
    const PosedScene scene = load(document);
    EXPECT_EQ(scene.triangles[0].a, vec3(0));
    EXPECT_EQ(scene.triangles[0].b, vec3(3, 4, 5));
}

// Indices may be sparse too: 0, 2, 1 from zeros.
TEST(GltfAccessor, substitutesSparseIndices) {
    Document document;
    const int positions = document.addPositions({0, 0, 0, 1, 0, 0, 2, 0, 0});
    const int indices = document.addView(bytesOf<uint8_t>({1, 2}));
    const int values = document.addView(bytesOf<uint16_t>({2, 1}));
    const int accessor = document.addAccessor(-1, 5123, 3, "SCALAR", sparse(indices, 5121, values, 2));
    document.addMesh(positions, accessor);
    EXPECT_EQ(xOf(load(document)), (std::vector<float>{0, 2, 1}));
}

TEST(GltfAccessor, refusesSparseIndicesThatDoNotIncreaseOrReachTooFar) {
    for (const std::vector<uint8_t>& list : {std::vector<uint8_t>{1, 1}, {2, 0}, {0, 3}}) {
        Document document;
        const int indices = document.addView(bytesOf(list));
        const int values = document.addView(bytesOf<float>({3, 4, 5, 6, 7, 8}));
        document.addMesh(document.addAccessor(-1, 5126, 3, "VEC3", sparse(indices, 5121, values, 2)));
        EXPECT_NE(refusal(document).find("sparse"), std::string::npos);
    }
}

TEST(GltfAccessor, refusesWhatReachesPastItsData) {
    auto spoiled = [](const char* array, const char* field, uint64_t value) {
        Document document = triangleDocument();
        document.json[array][0][field] = value;
        return refusal(document);
    };
    EXPECT_EQ(refusal(triangleDocument()), "");
    EXPECT_NE(spoiled("accessors", "count", 4).find("holds 3"), std::string::npos);
    EXPECT_NE(spoiled("accessors", "byteOffset", 4).find("holds 2"), std::string::npos);
    EXPECT_NE(spoiled("accessors", "byteOffset", uint64_t(1) << 40).find("holds 0"), std::string::npos);
    EXPECT_NE(spoiled("bufferViews", "byteLength", 37).find("past the end"), std::string::npos);
    EXPECT_NE(spoiled("bufferViews", "byteOffset", 1).find("past the end"), std::string::npos);
    EXPECT_NE(spoiled("bufferViews", "byteStride", 8).find("byteStride"), std::string::npos);
    EXPECT_NE(spoiled("accessors", "count", uint64_t(1) << 47).find("holds 3"), std::string::npos);
    EXPECT_NE(spoiled("accessors", "count", ~uint64_t(0)).find("whole number"), std::string::npos);
    EXPECT_NE(spoiled("bufferViews", "byteOffset", ~uint64_t(0) - 3).find("whole number"), std::string::npos);
}

TEST(GltfAccessor, refusesIndicesOfOtherVertices) {
    Document document;
    const int positions = document.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    document.addMesh(positions, document.addIndices<uint16_t>({0, 1, 3}));
    EXPECT_NE(refusal(document).find("holds the index 3, and there are 3 vertices"), std::string::npos);
}

TEST(GltfAccessor, refusesTypesThatAreNeitherPositionsNorIndices) {
    Document flat = triangleDocument();
    flat.json["accessors"][0]["type"] = "VEC2";
    EXPECT_NE(refusal(flat).find("must hold VEC3"), std::string::npos);
    Document strange = triangleDocument();
    strange.json["accessors"][0]["type"] = "VEC5";
    EXPECT_NE(refusal(strange).find("must hold VEC3"), std::string::npos);
    Document integers = triangleDocument();
    integers.json["accessors"][0]["componentType"] = 5125;
    EXPECT_NE(refusal(integers).find("must hold VEC3 of floats or of integers of 8 or 16 bits"), std::string::npos);
    Document document;
    const int positions = document.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    document.addMesh(positions, document.addAccessor(document.addView(bytesOf<float>({0, 1, 2})), 5126, 3, "SCALAR"));
    EXPECT_NE(refusal(document).find("must hold SCALAR of integers without sign"), std::string::npos);
}

}  // namespace
}  // namespace cleave::test
