// Decompresses bufferViews by meshoptimizer. Each becomes a buffer of its own.
#include <meshoptimizer.h>

#include "scene/check_values.h"
#include "scene/decompress.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

using gltf::MeshoptFilter;
using gltf::MeshoptMode;

// Attributes take at least two bits for sixteen bytes; indices take more.
constexpr uint64_t kMostExpansion = 64;

using Bytes = std::vector<unsigned char>;

// Returns 0 if all went well.
int decode(const gltf::Meshopt& meshopt, const unsigned char* source, Bytes& bytes) {
    switch (meshopt.mode) {
        case MeshoptMode::attributes:
            return meshopt_decodeVertexBuffer(bytes.data(), meshopt.count, meshopt.byteStride, source,
                                              meshopt.byteLength);
        case MeshoptMode::triangles:
            return meshopt_decodeIndexBuffer(bytes.data(), meshopt.count, meshopt.byteStride, source,
                                             meshopt.byteLength);
        case MeshoptMode::indices:
            return meshopt_decodeIndexSequence(bytes.data(), meshopt.count, meshopt.byteStride, source,
                                               meshopt.byteLength);
    }
    return -1;
}

void applyFilter(const gltf::Meshopt& meshopt, Bytes& bytes) {
    if (meshopt.filter == MeshoptFilter::octahedral)
        meshopt_decodeFilterOct(bytes.data(), meshopt.count, meshopt.byteStride);
    if (meshopt.filter == MeshoptFilter::quaternion)
        meshopt_decodeFilterQuat(bytes.data(), meshopt.count, meshopt.byteStride);
    if (meshopt.filter == MeshoptFilter::exponential)
        meshopt_decodeFilterExp(bytes.data(), meshopt.count, meshopt.byteStride);
}

Bytes decompressed(const gltf::Meshopt& meshopt, const Bytes& source, DecompressionBudget& budget,
                   const std::string& where) {
    const uint64_t size = meshopt.byteStride * meshopt.count;
    if (size / kMostExpansion > meshopt.byteLength)
        refuseGltf(where + " cannot become " + std::to_string(size) + " bytes: meshopt compresses to a " +
                   std::to_string(kMostExpansion) + "th at most");
    spend(budget, size, where);
    Bytes bytes(size);
    if (size == 0) return bytes;
    if (decode(meshopt, source.data() + meshopt.byteOffset, bytes) != 0)
        refuseGltf(where + " cannot be decompressed by meshopt: it is broken, or of a version that is not known");
    applyFilter(meshopt, bytes);
    return bytes;
}

}  // namespace

void decompressMeshopt(Scene& scene, const ShownParts& read, DecompressionBudget& budget) {
    for (size_t i = 0; i < scene.bufferViews.size(); ++i) {
        gltf::BufferView& view = scene.bufferViews[i];
        if (!read.views[i] || !view.meshopt || scene.buffers[view.meshopt->buffer].bytes.empty()) continue;
        Bytes bytes =
            decompressed(*view.meshopt, scene.buffers[view.meshopt->buffer].bytes, budget, at("bufferViews", i));
        view.buffer = uint32_t(scene.buffers.size());
        view.byteOffset = 0;
        view.meshopt.reset();
        scene.buffers.push_back({std::move(bytes), view.byteLength});
    }
}

}  // namespace cleave
