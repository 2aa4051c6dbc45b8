#include "scene/triangle_count.h"

#include "scene/instances.h"
#include "scene/node_transforms.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

// Counts up to `most`, and returns `most` + 1 if there are more.
size_t trianglesOf(const Scene& scene, const gltf::Mesh& mesh, size_t most) {
    size_t sum = 0;
    for (const gltf::Primitive& primitive : mesh.primitives) {
        if (!isReadable(scene, primitive)) continue;
        const size_t count = triangleCount(primitive.mode, indexCountOf(scene, primitive));
        if (count > most - sum) return most + 1;
        sum += count;
    }
    return sum;
}

}  // namespace

size_t indexCountOf(const Scene& scene, const gltf::Primitive& primitive) {
    return scene.accessors[primitive.indices ? *primitive.indices : primitive.attributes.at("POSITION")].count;
}

size_t triangleCount(gltf::Mode mode, size_t indexCount) {
    if (mode < gltf::Mode::triangles) return 0;
    if (mode == gltf::Mode::triangles) return indexCount / 3;
    return indexCount < 3 ? 0 : indexCount - 2;
}

size_t surplusIndices(gltf::Mode mode, size_t indexCount) {
    if (mode == gltf::Mode::triangles) return indexCount % 3;
    return indexCount < 3 ? indexCount : 0;
}

// glTF 2.0, section 3.7.2.1: every other triangle of a strip is turned around, so that all face the same way; a fan's
// centre comes last.
std::array<size_t, 3> cornersOf(gltf::Mode mode, size_t i) {
    if (mode == gltf::Mode::triangleStrip) return {i, i + 1 + i % 2, i + 2 - i % 2};
    if (mode == gltf::Mode::triangleFan) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

bool hasBytesOfView(const Scene& scene, uint32_t view) {
    return !scene.buffers[scene.bufferViews[view].buffer].bytes.empty();
}

bool hasBytes(const Scene& scene, uint32_t index) {
    const gltf::Accessor& accessor = scene.accessors[index];
    if (accessor.view && !hasBytesOfView(scene, *accessor.view)) return false;
    return !accessor.sparse ||
           (hasBytesOfView(scene, accessor.sparse->indicesView) && hasBytesOfView(scene, accessor.sparse->valuesView));
}

bool isReadable(const Scene& scene, const gltf::Primitive& primitive) {
    if (primitive.draco) return false;  // what it is decompressed from is not there
    const auto position = primitive.attributes.find("POSITION");
    return position != primitive.attributes.end() && hasBytes(scene, position->second) &&
           (!primitive.indices || hasBytes(scene, *primitive.indices));
}

size_t countTriangles(const Scene& scene, size_t most) {
    std::vector<size_t> counts;
    for (const gltf::Mesh& mesh : scene.meshes) counts.push_back(trianglesOf(scene, mesh, most));
    size_t sum = 0;
    for (uint32_t index : shownNodes(scene)) {
        const gltf::Node& node = scene.nodes[index];
        if (!node.mesh) continue;
        const size_t count = counts[*node.mesh];
        const size_t instances = instanceCount(scene, node);
        if (count > 0 && instances > (most - sum) / count)
            refuseGltf("the scene has more than " + std::to_string(most) + " triangles", "split it");
        sum += instances * count;
    }
    return sum;
}

}  // namespace cleave
