// KHR_draco_mesh_compression: a compressed primitive is what the plain one would be, or is refused.
#include <draco/compression/encode.h>
#include <gtest/gtest.h>

#include "compressed.h"
#include "moving_triangle.h"
#include "scene/accessor_view.h"

namespace cleave::test {
namespace {

constexpr int kSequential = draco::MESH_SEQUENTIAL_ENCODING;
constexpr int kEdgebreaker = draco::MESH_EDGEBREAKER_ENCODING;

Json& extensionOf(Document& document) { return document.primitive()["extensions"]["KHR_draco_mesh_compression"]; }

// By both methods, and by the submethods that the encoder's speed chooses.
TEST(Draco, trianglesAreThoseOfThePlainFile) {
    for (const uint32_t n : {1u, 3u, 40u})
        for (const int method : {kSequential, kEdgebreaker})
            for (const int speed : {0, 5, 10}) {
                const PosedScene scene = load(dracoGrid(n, method, speed));
                EXPECT_EQ(scene.triangles.size(), size_t(2) * n * n);
                EXPECT_EQ(sortedTriangles(scene), sortedTriangles(load(plainGrid(n))))
                    << n << " " << method << " " << speed;
                EXPECT_TRUE(scene.warnings.empty());
            }
}

// Sequential data keeps its order, so triangles have the numbers of the plain file.
TEST(Draco, keepsTheOrderOfTriangles) {
    const PosedScene scene = load(dracoGrid(7, kSequential));
    const PosedScene plain = load(plainGrid(7));
    ASSERT_EQ(scene.triangles.size(), plain.triangles.size());
    EXPECT_EQ(std::memcmp(scene.triangles.data(), plain.triangles.data(), plain.triangles.size() * sizeof(Triangle)),
              0);
}

TEST(Draco, worksWithoutAnAccessorOfIndices) {
    Document document = dracoGrid(3, kEdgebreaker);
    document.primitive().erase("indices");
    EXPECT_EQ(load(document).triangles.size(), 18u);
}

// What Draco has takes the place of data that is there for others; what Draco does not have is read as usual.
TEST(Draco, takesThePlaceOfPlainData) {
    Document document = dracoGrid(1, kSequential);
    const int zeros = document.addView(std::string(72, '\0'));
    document.json["accessors"][0]["bufferView"] = zeros;
    document.json["accessors"][1]["bufferView"] = zeros;
    EXPECT_EQ(sortedTriangles(load(document)), sortedTriangles(load(plainGrid(1))));

    const int deltas = document.addPositions({0, 0, 5, 0, 0, 5, 0, 0, 5, 0, 0, 5});
    document.primitive()["targets"] = {{{"POSITION", deltas}}};
    document.json["meshes"][0]["weights"] = {1};
    Document plain = plainGrid(1);
    plain.primitive()["targets"] = {{{"POSITION", plain.addPositions({0, 0, 5, 0, 0, 5, 0, 0, 5, 0, 0, 5})}}};
    plain.json["meshes"][0]["weights"] = {1};
    EXPECT_EQ(sortedTriangles(load(document)), sortedTriangles(load(plain)));
}

// The triangle of skinDocument, whose joints Draco stores wider than their accessor says.
Document dracoSkin(uint16_t largest = 1) {
    draco::Mesh mesh;
    mesh.set_num_points(3);
    using draco::GeometryAttribute;
    addDracoAttribute(mesh, GeometryAttribute::POSITION, draco::DT_FLOAT32, Floats{0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
    addDracoAttribute(mesh, GeometryAttribute::GENERIC, draco::DT_UINT16,
                      std::vector<uint16_t>{0, 0, 0, 0, largest, 0, 0, 0, 0, largest, 0, 0}, 4);
    addDracoAttribute(mesh, GeometryAttribute::GENERIC, draco::DT_FLOAT32,
                      Floats{1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, 4);
    setTriangles(mesh, {0, 1, 2});
    Document document = skinDocument();
    const int view = document.addView(dracoBytes(mesh, kSequential));
    Json& attributes = document.primitive()["attributes"];
    for (const Json& accessor : attributes) document.json["accessors"][accessor.get<size_t>()].erase("bufferView");
    document.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}}}};
    return document;
}

TEST(Draco, convertsWholeNumbersThatFit) {
    EXPECT_EQ(sortedTriangles(load(dracoSkin())), sortedTriangles(load(skinDocument())));
    EXPECT_NE(refusal(dracoSkin(256)).find("attributes.JOINTS_0 holds values that are not of the type"),
              std::string::npos);
}

// Quantized attributes with seams: a cube's corners have three normals each, which are unit vectors along axes.
TEST(Draco, readsAttributesWithSeams) {
    Floats positions;
    Floats normals;
    std::vector<uint32_t> indices;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const uint32_t first = uint32_t(positions.size() / 3);
            for (const auto& [u, v] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {-1.0f, 1.0f}, {1.0f, 1.0f}}) {
                Floats position(3);
                Floats normal(3, 0.0f);
                position[size_t(axis)] = normal[size_t(axis)] = side;
                position[size_t(axis + 1) % 3] = u;
                position[size_t(axis + 2) % 3] = v;
                positions.insert(positions.end(), position.begin(), position.end());
                normals.insert(normals.end(), normal.begin(), normal.end());
            }
            indices.insert(indices.end(), {first, first + 1, first + 2, first + 1, first + 3, first + 2});
        }
    draco::Mesh mesh;
    mesh.set_num_points(24);
    addDracoAttribute(mesh, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, positions, 3);
    addDracoAttribute(mesh, draco::GeometryAttribute::NORMAL, draco::DT_FLOAT32, normals, 3);
    setTriangles(mesh, indices);
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 12);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 10);
    mesh.DeduplicateAttributeValues();
    draco::EncoderBuffer buffer;
    ASSERT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());

    Document document;
    const int view = document.addView({buffer.data(), buffer.size()});
    document.addMesh(addDracoAccessor(document, 5126, 24, "VEC3"), addDracoAccessor(document, 5123, 36, "SCALAR"));
    document.primitive()["attributes"]["NORMAL"] = addDracoAccessor(document, 5126, 24, "VEC3");
    document.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}};
    const Scene scene = sceneOf(document);
    const gltf::Primitive& primitive = scene.meshes[0].primitives[0];
    const AccessorValues position(scene, primitive.attributes.at("POSITION"));
    const AccessorValues normal(scene, primitive.attributes.at("NORMAL"));
    ASSERT_EQ(position.count(), 24u);
    for (size_t i = 0; i < 24; ++i) {
        // Along its normal, each vertex is at distance 1: the two attributes still belong together.
        EXPECT_NEAR(glm::dot(position.vec3(i), normal.vec3(i)), 1.0, 0.02) << i;
        EXPECT_NEAR(glm::length(position.vec3(i)), std::sqrt(3.0), 1e-3) << i;
    }
    EXPECT_EQ(pose(scene).triangles.size(), 12u);
}

TEST(Draco, refusesWhatDoesNotMatchTheDocument) {
    struct Case {
        const char* message;
        std::function<void(Document&)> spoil;
    };
    const std::vector<Case> cases = {
        {"bufferView is 5, and there are 1 bufferViews", [](Document& d) { extensionOf(d)["bufferView"] = 5; }},
        {"has no bufferView", [](Document& d) { extensionOf(d).erase("bufferView"); }},
        {"has no object 'attributes'", [](Document& d) { extensionOf(d).erase("attributes"); }},
        {"attributes.POSITION is -1", [](Document& d) { extensionOf(d)["attributes"]["POSITION"] = -1; }},
        {"attributes.NORMAL is no attribute of the primitive",
         [](Document& d) { extensionOf(d)["attributes"]["NORMAL"] = 0; }},
        {"attributes.POSITION is 3, and its Draco data has no such attribute",
         [](Document& d) { extensionOf(d)["attributes"]["POSITION"] = 3; }},
        {"has lists of triangles, and its mode is 5", [](Document& d) { d.primitive()["mode"] = 5; }},
        {"has 18 triangles, and its accessor has 57 indices",
         [](Document& d) { d.json["accessors"][1]["count"] = 57; }},
        {"has 16 vertices, and its accessors have 17", [](Document& d) { d.json["accessors"][0]["count"] = 17; }},
        {"has 16 vertices, and its accessors have 281474976710656",
         [](Document& d) { d.json["accessors"][0]["count"] = uint64_t(1) << 48; }},
        {"POSITION holds values that are not of the type that its accessor says",
         [](Document& d) { d.json["accessors"][0]["componentType"] = 5123; }},
        {"is compressed by Draco, and its accessor is sparse",
         [](Document& d) {
             d.json["accessors"][0]["sparse"] = {{"count", 0},
                                                 {"indices", {{"bufferView", 0}, {"componentType", 5121}}},
                                                 {"values", {{"bufferView", 0}}}};
         }},
        {"_ID is compressed by Draco, and its accessor holds neither numbers nor vectors",
         [](Document& d) {
             d.primitive()["attributes"]["_ID"] = d.addAccessor(-1, 5126, 16, "MAT2");
             extensionOf(d)["attributes"]["_ID"] = 0;
         }},
        {"_ID has 3 components, and its accessor has 2",
         [](Document& d) {
             d.primitive()["attributes"]["_ID"] = d.addAccessor(-1, 5126, 16, "VEC2");
             extensionOf(d)["attributes"]["_ID"] = 0;
         }},
        {"is no Draco data", [](Document& d) { d.data[0] = 'X'; }},
        {"is no Draco data", [](Document& d) { d.json["bufferViews"][0]["byteLength"] = 3; }},
        {"is of Draco's version 2.1, and KHR_draco_mesh_compression means 2.2", [](Document& d) { d.data[6] = 1; }},
        {"is of Draco's version 3.2", [](Document& d) { d.data[5] = 3; }},
        {"is Draco data, and no mesh", [](Document& d) { d.data[7] = 0; }},
        {"is Draco data, and no mesh", [](Document& d) { d.data[8] = 7; }},
        {"cannot be decompressed by Draco: it is broken",
         [](Document& d) { d.json["bufferViews"][0]["byteLength"] = d.data.size() - 9; }},
    };
    for (const int method : {kSequential, kEdgebreaker}) {
        ASSERT_EQ(refusal(dracoGrid(3, method)), "");
        for (const Case& each : cases) {
            Document document = dracoGrid(3, method);
            each.spoil(document);
            const std::string message = refusal(document);
            EXPECT_NE(message.find(each.message), std::string::npos) << each.message << ": '" << message << "'";
        }
    }
}

TEST(Draco, leavesOutWhatIsNowhere) {
    Document document = dracoGrid(3, kEdgebreaker);
    document.json["buffers"] = {{{"byteLength", document.data.size()}}};
    PosedScene scene = load(document);
    EXPECT_TRUE(scene.triangles.empty());
    EXPECT_EQ(scene.leftOut["primitivesWithoutData"], 1u);
}

// Writes a number as Draco does, in groups of seven bits.
std::string varint(uint64_t value) {
    std::string bytes;
    for (; value >= 128; value /= 128) bytes += char(value % 128 | 128);
    return bytes + char(value);
}

// A few bytes may announce any number of triangles and attributes; nothing of that size is allocated.
TEST(Draco, boundsWhatDataMayBecome) {
    const uint64_t triangles = (uint64_t(1) << 31) / 3;
    const std::string head = std::string("DRACO\2\2\1", 8);
    const std::string zeros(64, '\0');
    const std::vector<std::pair<const char*, std::string>> announced = {
        {"sequential", head + std::string("\0\0\0", 3) + varint(triangles) + varint(3) + zeros},
        {"edgebreaker", head + std::string("\1\0\0\0", 4) + varint(99) + varint(triangles) + '\0' + zeros},
        {"seams", head + std::string("\1\0\0\0", 4) + varint(99) + varint(1 << 20) + '\xff' + zeros}};
    for (const auto& [name, bytes] : announced) {
        Document document = dracoGrid(1, kSequential);
        document.data = bytes;
        document.json["bufferViews"][0]["byteLength"] = bytes.size();
        document.primitive().erase("indices");
        EXPECT_NE(refusal(document).find("so many triangles and attributes"), std::string::npos)
            << name << ": " << refusal(document);
        document.primitive()["indices"] = 1;
        EXPECT_NE(refusal(document).find("triangles, and its accessor has 6 indices"), std::string::npos)
            << name << ": " << refusal(document);
    }
    Document document = dracoGrid(1, kSequential);
    draco::Mesh mesh;
    fillGrid(mesh, 1);
    for (int i = 0; i < 70; ++i)
        addDracoAttribute(mesh, draco::GeometryAttribute::GENERIC, draco::DT_UINT8, std::vector<uint8_t>(4), 1);
    const std::string bytes = dracoBytes(mesh, kSequential);
    document.json["bufferViews"][0] = {{"buffer", 0}, {"byteLength", bytes.size()}};
    document.data = bytes;
    EXPECT_NE(refusal(document).find("has 71 attributes, and 64 is the most that is allowed"), std::string::npos);

    // Many primitives of the same bytes: each is possible, and all are too much.
    Document many = dracoGrid(9, kEdgebreaker);
    Json& primitives = many.json["meshes"][0]["primitives"];
    primitives = Json(50, primitives[0]);
    many.json.erase("nodes");
    many.json.erase("scenes");
    many.json.erase("scene");
    const std::string text = many.text();
    const std::vector<unsigned char> file(text.begin(), text.end());
    EXPECT_NO_THROW(loadGltf("scene.gltf", file, 1000)) << "nothing shows them";
    EXPECT_NO_THROW(loadGltf("scene.gltf", file, 10000, Reading::everything));
    try {
        loadGltf("scene.gltf", file, 1000, Reading::everything);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("is the most that is left for the scene"), std::string::npos);
    }
}

// The library takes any count of the orientations by which texture coordinates are predicted. Wherever in the data it
// is: a large one is refused before it is counted to, which takes a minute.
TEST(Draco, boundsThePredictionOfTextureCoordinates) {
    constexpr uint32_t n = 3;
    constexpr size_t kVertices = (n + 1) * (n + 1);
    draco::Mesh mesh;
    fillGrid(mesh, n);
    Floats coordinates;
    for (size_t i = 0; i < kVertices; ++i)
        coordinates.insert(coordinates.end(), {float(i % (n + 1)) / n, float(i / (n + 1)) / n});
    addDracoAttribute(mesh, draco::GeometryAttribute::TEX_COORD, draco::DT_FLOAT32, coordinates, 2);
    draco::Encoder encoder;
    encoder.SetSpeedOptions(3, 3);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 10);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 10);
    draco::EncoderBuffer buffer;
    ASSERT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());

    Document document;
    const int view = document.addView({buffer.data(), buffer.size()});
    document.addMesh(addDracoAccessor(document, 5126, kVertices, "VEC3"),
                     addDracoAccessor(document, 5123, 6 * n * n, "SCALAR"));
    document.primitive()["attributes"]["TEXCOORD_0"] = addDracoAccessor(document, 5126, kVertices, "VEC2");
    document.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}};
    const Scene scene = sceneOf(document);
    const AccessorValues values(scene, scene.meshes[0].primitives[0].attributes.at("TEXCOORD_0"));
    ASSERT_EQ(values.count(), kVertices);

    size_t found = 0;
    for (size_t at = 11; at + 4 <= document.data.size(); ++at) {
        Document spoilt = document;
        spoilt.data.replace(at, 4, "\xFF\xFF\xFF\x7F");
        found += refusal(spoilt).find("has 2147483647 orientations for 16 values") == std::string::npos ? 0 : 1;
    }
    EXPECT_EQ(found, 1u);
}

// Whatever the bytes are: a scene, or a sentence.
TEST(Draco, survivesSpoiltBytes) {
    constexpr unsigned kSeed = 1;
    std::minstd_rand random(kSeed);
    size_t refused = 0;
    for (const int method : {kSequential, kEdgebreaker})
        for (const int speed : {0, 10}) {
            const Document good = dracoGrid(9, method, speed);
            for (int i = 0; i < 500; ++i) {
                Document document = good;
                spoilBytes(document.data, random);
                const std::string message = refusal(document);
                EXPECT_EQ(message.find('\n'), std::string::npos) << "seed " << kSeed << ", round " << i;
                refused += message.empty() ? 0 : 1;
            }
        }
    EXPECT_GT(refused, 0u);
}

}  // namespace
}  // namespace cleave::test
