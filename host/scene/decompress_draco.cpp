// Decompresses primitives by Draco. Each then has accessors of its own.
#include "scene/check_format.h"
#include "scene/check_values.h"
#include "scene/decompress.h"
#include "scene/draco_mesh.h"
#include "scene/refuse.h"
#include "scene/triangle_count.h"

namespace cleave {
namespace {

size_t componentCount(gltf::ElementType type) {
    return elementSize(type, gltf::ComponentType::uint8);  // a byte each: it has no matrices
}

DracoRequest requestOf(const Scene& scene, const gltf::Primitive& primitive, size_t mostBytes) {
    DracoRequest request;
    request.mostBytes = mostBytes;
    if (primitive.indices) request.indices = scene.accessors[*primitive.indices].count;
    if (!primitive.attributes.empty()) request.vertices = scene.accessors[primitive.attributes.begin()->second].count;
    for (const auto& [semantic, id] : primitive.draco->ids) {
        const gltf::Accessor& accessor = scene.accessors[primitive.attributes.at(semantic)];
        request.attributes.push_back({id, accessor.componentType, componentCount(accessor.elementType), semantic});
    }
    return request;
}

std::span<const unsigned char> bytesOf(const Scene& scene, uint32_t index) {
    const gltf::BufferView& view = scene.bufferViews[index];
    return std::span(scene.buffers[view.buffer].bytes).subspan(view.byteOffset, view.byteLength);
}

// Adds an accessor of plain data, in a buffer of its own.
uint32_t addAccessor(Scene& scene, gltf::Accessor accessor, std::vector<unsigned char> bytes) {
    accessor.view = uint32_t(scene.bufferViews.size());
    accessor.byteOffset = 0;
    const size_t size = bytes.size();
    scene.bufferViews.push_back({uint32_t(scene.buffers.size()), 0, size, 0, std::nullopt});
    scene.buffers.push_back({std::move(bytes), size});
    scene.accessors.push_back(accessor);
    return uint32_t(scene.accessors.size()) - 1;
}

uint32_t addIndices(Scene& scene, const std::vector<uint32_t>& indices) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(indices.data());
    gltf::Accessor accessor;
    accessor.componentType = gltf::ComponentType::uint32;
    accessor.elementType = gltf::ElementType::scalar;
    accessor.count = indices.size();
    return addAccessor(scene, accessor, {bytes, bytes + indices.size() * sizeof(uint32_t)});
}

void decompressPrimitive(Scene& scene, gltf::Primitive& primitive, DecompressionBudget& budget,
                         const std::string& where) {
    DracoMesh mesh =
        decompressDracoMesh(bytesOf(scene, primitive.draco->view), requestOf(scene, primitive, budget.bytes), where);
    size_t size = mesh.indices.size() * sizeof(uint32_t);
    for (const std::vector<unsigned char>& values : mesh.attributes) size += values.size();
    spend(budget, size, where);
    size_t i = 0;
    for (const auto& [semantic, id] : primitive.draco->ids) {
        uint32_t& accessor = primitive.attributes.at(semantic);
        accessor = addAccessor(scene, scene.accessors[accessor], std::move(mesh.attributes[i++]));
    }
    primitive.indices = addIndices(scene, mesh.indices);
    primitive.draco.reset();
}

}  // namespace

void decompressDraco(Scene& scene, const ShownParts& read, DecompressionBudget& budget) {
    for (size_t m = 0; m < scene.meshes.size(); ++m) {
        if (!read.meshes[m]) continue;
        std::vector<gltf::Primitive>& primitives = scene.meshes[m].primitives;
        for (size_t p = 0; p < primitives.size(); ++p)
            if (primitives[p].draco && hasBytesOfView(scene, primitives[p].draco->view))
                decompressPrimitive(scene, primitives[p], budget,
                                    at(at("meshes", m) + ".primitives", p) + ".extensions.KHR_draco_mesh_compression");
    }
}

}  // namespace cleave
