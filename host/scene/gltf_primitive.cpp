#include "scene/gltf_primitive.h"

#include <array>

#include "scene/gltf_accessor.h"
#include "scene/gltf_file.h"

namespace cleave {
namespace {

vec3 toWorldPosition(const glm::dmat4& m, const glm::dvec3& p) {
    const glm::dvec4 q = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
    return {float(q.x), float(q.y), float(q.z)};
}

size_t triangleCount(int mode, size_t indexCount) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return indexCount / 3;
    return indexCount < 3 ? 0 : indexCount - 2;
}

// Which three indices make triangle i (glTF 2.0, section 3.7.2.1): every other one of a strip is turned around, so that
// all face the same way; a fan's centre comes last.
std::array<size_t, 3> corners(int mode, size_t i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return {i, i + 1 + i % 2, i + 2 - i % 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

size_t surplusIndices(int mode, size_t indexCount) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return indexCount % 3;
    return indexCount < 3 ? indexCount : 0;
}

void countLines(int mode, size_t n, Scene& scene) {
    if (mode == TINYGLTF_MODE_POINTS) scene.leftOut["points"] += n;
    if (mode == TINYGLTF_MODE_LINE) scene.leftOut["lines"] += n / 2;
    if (mode == TINYGLTF_MODE_LINE_STRIP) scene.leftOut["lines"] += n < 2 ? 0 : n - 1;
    if (mode == TINYGLTF_MODE_LINE_LOOP) scene.leftOut["lines"] += n < 2 ? 0 : n;
}

size_t indexCountOf(const tinygltf::Model& model, const tinygltf::Primitive& primitive, int positions) {
    return model.accessors[size_t(primitive.indices >= 0 ? primitive.indices : positions)].count;
}

// True if the primitive has positions that can be read from this file; else it is counted, and said why.
bool isReadable(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& where,
                Scene& scene) {
    const auto position = primitive.attributes.find("POSITION");
    const bool hasPositions = position != primitive.attributes.end();
    if (hasPositions && hasBytes(model, position->second) &&
        (primitive.indices < 0 || hasBytes(model, primitive.indices)))
        return true;
    scene.warnings.push_back(where + (hasPositions ? " is left out: its data is in a buffer that has no URI"
                                                   : " is left out: it has no POSITION"));
    ++scene.leftOut[hasPositions ? "primitivesWithoutData" : "primitivesWithoutPosition"];
    return false;
}

// A compressed primitive may come with plain accessors to fall back on. Without, they would read as zeros.
void refuseCompressed(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& where) {
    if (primitive.extensions.find("KHR_draco_mesh_compression") == primitive.extensions.end()) return;
    const auto position = primitive.attributes.find("POSITION");
    const bool plain = position != primitive.attributes.end() &&
                       model.accessors[size_t(position->second)].bufferView >= 0 &&
                       (primitive.indices < 0 || model.accessors[size_t(primitive.indices)].bufferView >= 0);
    if (!plain)
        refuseGltf(where + " needs the extension KHR_draco_mesh_compression, which is not supported",
                   "export it without that extension");
}

}  // namespace

void addPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const glm::dmat4& toWorld,
                  const std::string& where, size_t mostTriangles, Scene& scene) {
    refuseCompressed(model, primitive, where);
    if (!isReadable(model, primitive, where, scene)) return;
    const int mode = primitive.mode;
    const int positionAccessor = primitive.attributes.at("POSITION");
    const size_t indexCount = indexCountOf(model, primitive, positionAccessor);
    if (mode < TINYGLTF_MODE_TRIANGLES) return countLines(mode, indexCount, scene);

    const size_t count = triangleCount(mode, indexCount);
    if (count > mostTriangles - scene.triangles.size())
        refuseGltf("the scene has more than " + std::to_string(mostTriangles) + " triangles", "split it");
    if (const size_t surplus = surplusIndices(mode, indexCount); surplus > 0) {
        scene.leftOut["surplusIndices"] += surplus;
        scene.warnings.push_back(where + " has " + std::to_string(indexCount) + " indices: the last " +
                                 std::to_string(surplus) + " make no triangle and are left out");
    }
    const Positions positions(model, positionAccessor);
    const VertexIndices indices(model, primitive.indices, positions.count());
    const uint32_t material = uint32_t(primitive.material >= 0 ? primitive.material : int(model.materials.size()));
    for (size_t i = 0; i < count; ++i) {
        const std::array<size_t, 3> corner = corners(mode, i);
        auto vertex = [&](size_t k) { return toWorldPosition(toWorld, positions[indices[corner[k]]]); };
        scene.triangles.push_back({vertex(0), vertex(1), vertex(2)});
        scene.materialOf.push_back(material);
    }
}

}  // namespace cleave
