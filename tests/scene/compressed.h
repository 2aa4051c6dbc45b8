// Data as encoders of the libraries compress it, and scenes that are made of it.
#pragma once

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <random>

#include "gltf_text.h"

namespace cleave::test {

// A wavy grid of n x n squares: positions that floats hold exactly, and two triangles for each square.
struct Grid {
    std::vector<float> positions;
    std::vector<uint32_t> indices;
};
inline Grid wavyGrid(uint32_t n) {
    Grid grid;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x)
            grid.positions.insert(grid.positions.end(), {float(x), float(y), float((x * x + 3 * y) % 7) * 0.125f});
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t corner = y * (n + 1) + x;
            grid.indices.insert(grid.indices.end(),
                                {corner, corner + 1, corner + n + 1, corner + 1, corner + n + 2, corner + n + 1});
        }
    return grid;
}

inline Document plainGrid(uint32_t n) {
    const Grid grid = wavyGrid(n);
    Document document;
    const int positions = document.addPositions(grid.positions);
    document.addMesh(positions, document.addIndices(grid.indices));
    return document;
}

// Triangles whose corners are turned so that the least comes first, sorted: what encoders may reorder does not count.
inline std::vector<std::array<float, 9>> sortedTriangles(const PosedScene& scene) {
    std::vector<std::array<float, 9>> all;
    for (const Triangle& t : scene.triangles) {
        std::array<std::array<float, 3>, 3> corners = {
            {{t.a.x, t.a.y, t.a.z}, {t.b.x, t.b.y, t.b.z}, {t.c.x, t.c.y, t.c.z}}};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::array<float, 9>& flat = all.emplace_back();
        for (size_t i = 0; i < 9; ++i) flat[i] = corners[i / 3][i % 3];
    }
    std::sort(all.begin(), all.end());
    return all;
}

// Compresses elements of `stride` bytes.
inline std::string meshoptAttributes(const std::string& bytes, size_t stride) {
    std::vector<unsigned char> coded(meshopt_encodeVertexBufferBound(bytes.size() / stride, stride));
    coded.resize(meshopt_encodeVertexBuffer(coded.data(), coded.size(), bytes.data(), bytes.size() / stride, stride));
    return bytesOf(coded);
}
inline std::string meshoptTriangles(const std::vector<uint32_t>& indices) {
    std::vector<unsigned char> coded(meshopt_encodeIndexBufferBound(indices.size(), indices.size()));
    coded.resize(meshopt_encodeIndexBuffer(coded.data(), coded.size(), indices.data(), indices.size()));
    return bytesOf(coded);
}
inline std::string meshoptIndices(const std::vector<uint32_t>& indices) {
    std::vector<unsigned char> coded(meshopt_encodeIndexSequenceBound(indices.size(), indices.size()));
    coded.resize(meshopt_encodeIndexSequence(coded.data(), coded.size(), indices.data(), indices.size()));
    return bytesOf(coded);
}

// Adds a bufferView that is compressed in buffer 0; its own buffer is number 1, a fallback of which nothing is there.
inline int addMeshoptView(Document& document, const std::string& coded, size_t count, size_t stride, const char* mode,
                          const char* filter = nullptr, const char* extension = "EXT_meshopt_compression") {
    const int view = document.addView(coded);
    Json& json = document.json["bufferViews"][size_t(view)];
    Json meshopt = json;
    meshopt.update({{"count", count}, {"byteStride", stride}, {"mode", mode}});
    if (filter != nullptr) meshopt["filter"] = filter;
    json = {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{extension, meshopt}}}};
    if (std::string(mode) == "ATTRIBUTES") json["byteStride"] = stride;
    return view;
}

// The document's buffer 0, and number 1 that stands for what is not compressed.
inline Document withFallback(Document document, size_t size = size_t(1) << 20) {
    document.json["buffers"] = {
        {{"byteLength", document.data.size()},
         {"uri", "data:application/octet-stream;base64," + base64(document.data)}},
        {{"byteLength", size}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    return document;
}

inline Document meshoptGrid(uint32_t n) {
    const Grid grid = wavyGrid(n);
    const size_t vertices = grid.positions.size() / 3;
    Document document;
    const int positions =
        addMeshoptView(document, meshoptAttributes(bytesOf(grid.positions), 12), vertices, 12, "ATTRIBUTES");
    const int indices = addMeshoptView(document, meshoptTriangles(grid.indices), grid.indices.size(), 4, "TRIANGLES");
    document.addMesh(document.addAccessor(positions, 5126, vertices, "VEC3"),
                     document.addAccessor(indices, 5125, grid.indices.size(), "SCALAR"));
    return withFallback(document);
}

// An attribute for Draco: `components` numbers for each vertex.
template <typename Number>
int addDracoAttribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType dataType,
                      const std::vector<Number>& values, size_t components, bool normalized = false) {
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, uint8_t(components), dataType, normalized, int64_t(components * sizeof(Number)), 0);
    const int id = mesh.AddAttribute(attribute, true, uint32_t(values.size() / components));
    for (size_t i = 0; i < values.size() / components; ++i)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(uint32_t(i)), &values[i * components]);
    return id;
}

inline void setTriangles(draco::Mesh& mesh, const std::vector<uint32_t>& indices) {
    for (size_t i = 0; i + 2 < indices.size(); i += 3)
        mesh.AddFace(
            {draco::PointIndex(indices[i]), draco::PointIndex(indices[i + 1]), draco::PointIndex(indices[i + 2])});
}

inline void fillGrid(draco::Mesh& mesh, uint32_t n) {
    const Grid grid = wavyGrid(n);
    mesh.set_num_points(uint32_t(grid.positions.size() / 3));
    addDracoAttribute(mesh, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, grid.positions, 3);
    setTriangles(mesh, grid.indices);
}

// Without quantization, so that floats stay what they are.
inline std::string dracoBytes(const draco::Mesh& mesh, int method, int speed = 5) {
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(method);
    encoder.SetSpeedOptions(speed, speed);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeToBuffer(&buffer).ok()) throw Error("Draco cannot encode a mesh of the tests");
    return {buffer.data(), buffer.size()};
}

// Adds an accessor without a bufferView, whose data Draco has.
inline int addDracoAccessor(Document& document, int componentType, size_t count, const char* type) {
    return document.addAccessor(-1, componentType, count, type);
}

inline Document dracoGrid(uint32_t n, int method, int speed = 5) {
    draco::Mesh mesh;
    fillGrid(mesh, n);
    Document document;
    const int view = document.addView(dracoBytes(mesh, method, speed));
    const int positions = addDracoAccessor(document, 5126, (n + 1) * (n + 1), "VEC3");
    const int indices = addDracoAccessor(document, 5125, size_t(n) * n * 6, "SCALAR");
    document.addMesh(
        positions, indices,
        {{"extensions", {{"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}}}}}});
    return document;
}

// One to three bytes of a document's data changed at random.
inline void spoilBytes(std::string& data, std::minstd_rand& random) {
    for (size_t i = 1 + random() % 3; i > 0; --i) data[random() % data.size()] = char(random() % 256);
}

}  // namespace cleave::test
