#include "scene/accessor_view.h"

#include <algorithm>
#include <cstring>

#include "scene/check_format.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

using gltf::ComponentType;

std::string nameOf(uint32_t accessor) { return "accessors[" + std::to_string(accessor) + "]"; }

template <typename Value>
Value load(const unsigned char* bytes) {
    Value value;
    std::memcpy(&value, bytes, sizeof(value));  // files are not always aligned as they should be
    return value;
}

// Offsets and lengths are at most kMaxCount, so no sum overflows.
StridedBytes bytesOfView(const Scene& scene, uint32_t viewIndex, uint64_t offset, size_t count, size_t elementSize,
                         bool mayStride, const std::string& where) {
    const gltf::BufferView& view = scene.bufferViews[viewIndex];
    const std::vector<unsigned char>& bytes = scene.buffers[view.buffer].bytes;
    if (bytes.empty()) refuseGltf(where + " is in " + at("buffers", view.buffer) + ", which is not there");
    const size_t stride = mayStride && view.byteStride != 0 ? view.byteStride : elementSize;
    const bool inBuffer = view.byteOffset + view.byteLength <= bytes.size();
    if (!inBuffer || stride < elementSize || count > fittingElements(view.byteLength, offset, stride, elementSize))
        refuseGltf(where + " reaches past the end of its data");
    return {bytes.data() + (count > 0 ? view.byteOffset + offset : 0), count, stride};
}

uint32_t loadIndex(const unsigned char* bytes, ComponentType type) {
    if (type == ComponentType::uint8) return *bytes;
    return type == ComponentType::uint16 ? load<uint16_t>(bytes) : load<uint32_t>(bytes);
}

// glTF 2.0, section 3.11: signed values are symmetric, so the lowest one is clamped.
template <typename Integer>
double integerComponent(const unsigned char* bytes, size_t i, bool normalized) {
    const double value = load<Integer>(bytes + i * sizeof(Integer));
    return normalized ? std::max(value / std::numeric_limits<Integer>::max(), -1.0) : value;
}

double component(const unsigned char* bytes, size_t i, ComponentType type, bool normalized) {
    switch (type) {
        case ComponentType::int8:
            return integerComponent<int8_t>(bytes, i, normalized);
        case ComponentType::uint8:
            return integerComponent<uint8_t>(bytes, i, normalized);
        case ComponentType::int16:
            return integerComponent<int16_t>(bytes, i, normalized);
        case ComponentType::uint16:
            return integerComponent<uint16_t>(bytes, i, normalized);
        case ComponentType::uint32:
            return integerComponent<uint32_t>(bytes, i, normalized);
        case ComponentType::float32:
            break;
    }
    return load<float>(bytes + i * sizeof(float));
}

}  // namespace

AccessorElements::AccessorElements(const Scene& scene, uint32_t index) : where_(nameOf(index)) {
    const gltf::Accessor& accessor = scene.accessors[index];
    const size_t size = elementSize(accessor.elementType, accessor.componentType);
    if (size == 0) refuseGltf(where_ + " has a type that is not known");
    base_.count = accessor.count;
    if (accessor.view)
        base_ = bytesOfView(scene, *accessor.view, accessor.byteOffset, accessor.count, size, true, where_);
    if (accessor.sparse) readSparse(scene, accessor, size);
}

void AccessorElements::readSparse(const Scene& scene, const gltf::Accessor& accessor, size_t size) {
    const gltf::Sparse& sparse = *accessor.sparse;
    const StridedBytes indices = bytesOfView(scene, sparse.indicesView, sparse.indicesOffset, sparse.count,
                                             componentSize(sparse.indicesType), false, where_ + ".sparse.indices");
    sparseValues_ = bytesOfView(scene, sparse.valuesView, sparse.valuesOffset, sparse.count, size, false,
                                where_ + ".sparse.values");
    for (size_t i = 0; i < sparse.count; ++i) {
        sparseIndices_.push_back(loadIndex(indices.at(i), sparse.indicesType));
        if (sparseIndices_[i] >= base_.count || (i > 0 && sparseIndices_[i] <= sparseIndices_[i - 1]))
            refuseGltf(where_ + ".sparse has indices that do not increase, or reach past its end");
    }
}

const unsigned char* AccessorElements::operator[](size_t i) const {
    const auto found = std::lower_bound(sparseIndices_.begin(), sparseIndices_.end(), i);
    if (found != sparseIndices_.end() && *found == i) return sparseValues_.at(size_t(found - sparseIndices_.begin()));
    return base_.data == nullptr ? nullptr : base_.at(i);
}

AccessorValues::AccessorValues(const Scene& scene, uint32_t index)
    : elements_(scene, index),
      type_(scene.accessors[index].componentType),
      normalized_(scene.accessors[index].normalized) {}

double AccessorValues::scalar(size_t i) const {
    const unsigned char* bytes = elements_[i];
    return bytes == nullptr ? 0.0 : component(bytes, 0, type_, normalized_);
}

glm::dvec2 AccessorValues::vec2(size_t i) const {
    const unsigned char* bytes = elements_[i];
    if (bytes == nullptr) return glm::dvec2(0.0);
    return {component(bytes, 0, type_, normalized_), component(bytes, 1, type_, normalized_)};
}

glm::dvec3 AccessorValues::vec3(size_t i) const {
    const unsigned char* bytes = elements_[i];
    if (bytes == nullptr) return glm::dvec3(0.0);
    return {component(bytes, 0, type_, normalized_), component(bytes, 1, type_, normalized_),
            component(bytes, 2, type_, normalized_)};
}

glm::dvec4 AccessorValues::vec4(size_t i) const {
    const unsigned char* bytes = elements_[i];
    if (bytes == nullptr) return glm::dvec4(0.0);
    return {component(bytes, 0, type_, normalized_), component(bytes, 1, type_, normalized_),
            component(bytes, 2, type_, normalized_), component(bytes, 3, type_, normalized_)};
}

glm::dmat4 AccessorValues::mat4(size_t i) const {
    const unsigned char* bytes = elements_[i];
    glm::dmat4 matrix(0.0);
    for (int k = 0; bytes != nullptr && k < 16; ++k) matrix[k / 4][k % 4] = component(bytes, size_t(k), type_, false);
    return matrix;
}

AccessorIntegers::AccessorIntegers(const Scene& scene, uint32_t index)
    : elements_(scene, index), type_(scene.accessors[index].componentType) {}

glm::uvec4 AccessorIntegers::operator[](size_t i) const {
    const unsigned char* bytes = elements_[i];
    glm::uvec4 numbers(0);
    for (int k = 0; bytes != nullptr && k < 4; ++k)
        numbers[k] = loadIndex(bytes + size_t(k) * componentSize(type_), type_);
    return numbers;
}

VertexIndices::VertexIndices(const Scene& scene, gltf::Index index, size_t vertexCount) {
    if (!index) return;
    const AccessorElements elements(scene, *index);
    const ComponentType type = scene.accessors[*index].componentType;
    indices_.resize(elements.count());
    for (size_t i = 0; i < indices_.size(); ++i) {
        const unsigned char* bytes = elements[i];
        indices_[i] = bytes == nullptr ? 0 : loadIndex(bytes, type);
        if (indices_[i] >= vertexCount)
            refuseGltf(nameOf(*index) + " holds the index " + std::to_string(indices_[i]) + ", and there are " +
                       std::to_string(vertexCount) + " vertices");
    }
}

}  // namespace cleave
