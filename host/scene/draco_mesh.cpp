#include "scene/draco_mesh.h"

#include <cstring>
#include <utility>

#include "scene/check_format.h"
#include "scene/draco_decoder.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

using gltf::ComponentType;

template <typename From, typename To>
bool convert(const unsigned char* from, unsigned char* to) {
    From value;
    std::memcpy(&value, from, sizeof(value));
    if (!std::in_range<To>(value)) return false;
    const To converted = To(value);
    std::memcpy(to, &converted, sizeof(converted));
    return true;
}

template <typename From>
bool convertTo(ComponentType type, const unsigned char* from, unsigned char* to) {
    switch (type) {
        case ComponentType::int8:
            return convert<From, int8_t>(from, to);
        case ComponentType::uint8:
            return convert<From, uint8_t>(from, to);
        case ComponentType::int16:
            return convert<From, int16_t>(from, to);
        case ComponentType::uint16:
            return convert<From, uint16_t>(from, to);
        case ComponentType::uint32:
            return convert<From, uint32_t>(from, to);
        case ComponentType::float32:
            break;
    }
    return false;
}

// Copies a component. Whole numbers may be stored wider or narrower than their accessor says, if they fit.
bool copyComponent(draco::DataType stored, ComponentType type, const unsigned char* from, unsigned char* to) {
    switch (stored) {
        case draco::DT_INT8:
            return convertTo<int8_t>(type, from, to);
        case draco::DT_UINT8:
            return convertTo<uint8_t>(type, from, to);
        case draco::DT_INT16:
            return convertTo<int16_t>(type, from, to);
        case draco::DT_UINT16:
            return convertTo<uint16_t>(type, from, to);
        case draco::DT_INT32:
            return convertTo<int32_t>(type, from, to);
        case draco::DT_UINT32:
            return convertTo<uint32_t>(type, from, to);
        case draco::DT_FLOAT32:
            if (type != ComponentType::float32) return false;
            std::memcpy(to, from, sizeof(float));
            return true;
        default:
            return false;
    }
}

// Returns the values of an attribute by vertex.
std::vector<unsigned char> valuesOf(const draco::Mesh& mesh, const DracoAttribute& asked, const std::string& where) {
    const std::string name = where + ".attributes." + asked.name;
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(asked.id);
    if (attribute == nullptr)
        refuseGltf(name + " is " + std::to_string(asked.id) + ", and its Draco data has no such attribute");
    if (attribute->num_components() != asked.components)
        refuseGltf(name + " has " + std::to_string(attribute->num_components()) + " components, and its accessor has " +
                   std::to_string(asked.components));
    const size_t size = componentSize(asked.type);
    const auto storedSize = size_t(draco::DataTypeLength(attribute->data_type()));
    const size_t storedStride = storedSize * asked.components;
    const draco::DataBuffer& stored = *attribute->buffer();
    std::vector<unsigned char> values(mesh.num_points() * asked.components * size);
    unsigned char* to = values.data();
    for (uint32_t vertex = 0; vertex < mesh.num_points(); ++vertex) {
        const uint64_t entry = attribute->mapped_index(draco::PointIndex(vertex)).value();
        if ((entry + 1) * storedStride > stored.data_size()) refuseGltf(name + " lacks values of its vertices");
        const unsigned char* from = stored.data() + entry * storedStride;
        for (size_t k = 0; k < asked.components; ++k, from += storedSize, to += size)
            if (!copyComponent(attribute->data_type(), asked.type, from, to))
                refuseGltf(name + " holds values that are not of the type that its accessor says");
    }
    return values;
}

std::vector<uint32_t> indicesOf(const draco::Mesh& mesh, const std::string& where) {
    std::vector<uint32_t> indices;
    indices.reserve(size_t(mesh.num_faces()) * 3);
    for (uint32_t i = 0; i < mesh.num_faces(); ++i)
        for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) {
            if (corner.value() >= mesh.num_points()) refuseGltf(where + " has a triangle without a vertex");
            indices.push_back(corner.value());
        }
    return indices;
}

}  // namespace

DracoMesh decompressDracoMesh(std::span<const unsigned char> bytes, const DracoRequest& request,
                              const std::string& where) {
    draco::Mesh mesh;
    decodeDraco(bytes, request, where, mesh);
    DracoMesh result;
    result.vertices = mesh.num_points();
    result.indices = indicesOf(mesh, where);
    if (request.indices && result.indices.size() != *request.indices)
        refuseGltf(where + " has other counts in its head than in its body");
    for (const DracoAttribute& attribute : request.attributes)
        result.attributes.push_back(valuesOf(mesh, attribute, where));
    return result;
}

}  // namespace cleave
