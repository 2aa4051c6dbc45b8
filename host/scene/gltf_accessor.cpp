#include "scene/gltf_accessor.h"

#include <algorithm>
#include <cstring>

#include "scene/gltf_file.h"

namespace cleave {
namespace {

const tinygltf::BufferView& viewOf(const tinygltf::Model& model, int view) { return model.bufferViews[size_t(view)]; }

template <typename Value>
Value load(const unsigned char* bytes) {
    Value value;
    std::memcpy(&value, bytes, sizeof(value));  // files are not always aligned as they should be
    return value;
}

// Counts and offsets are below 2^48 (gltf_check), so no sum overflows; the product is turned into a division.
StridedBytes checkedBytes(const tinygltf::Model& model, int viewIndex, size_t offset, size_t count, size_t elementSize,
                          bool mayStride, const std::string& where) {
    const tinygltf::BufferView& view = viewOf(model, viewIndex);
    const std::vector<unsigned char>& buffer = model.buffers[size_t(view.buffer)].data;
    if (view.byteOffset + view.byteLength > buffer.size())
        refuseGltf("bufferViews[" + std::to_string(viewIndex) + "] reaches past the end of its buffer");
    const size_t stride = mayStride && view.byteStride != 0 ? view.byteStride : elementSize;
    if (stride < elementSize) refuseGltf(where + " has elements that are larger than its byteStride");
    const size_t room = offset < view.byteLength ? view.byteLength - offset : 0;
    const size_t fitting = room < elementSize ? 0 : (room - elementSize) / stride + 1;
    if (count > fitting)
        refuseGltf(where + " has " + std::to_string(count) + " elements, and its bufferView has room for " +
                   std::to_string(fitting));
    return {buffer.data() + (count > 0 ? view.byteOffset + offset : 0), count, stride};
}

size_t elementSizeOf(const tinygltf::Accessor& accessor, const std::string& where) {
    const int component = tinygltf::GetComponentSizeInBytes(uint32_t(accessor.componentType));
    const int components = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
    if (component <= 0 || components <= 0) refuseGltf(where + " has a type that is not known");
    return size_t(component) * size_t(components);
}

uint32_t loadIndex(const unsigned char* bytes, int componentType, const std::string& where) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return *bytes;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<uint16_t>(bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return load<uint32_t>(bytes);
        default:
            refuseGltf(where + " holds indices, and they are not of 8, 16 or 32 bits without sign");
    }
}

std::string nameOf(int accessor) { return "accessors[" + std::to_string(accessor) + "]"; }

// glTF 2.0, section 3.11: signed values are symmetric, so the lowest one is clamped.
template <typename Integer>
double component(const unsigned char* bytes, size_t axis, bool normalized) {
    const double value = load<Integer>(bytes + axis * sizeof(Integer));
    return normalized ? std::max(value / std::numeric_limits<Integer>::max(), -1.0) : value;
}

double positionComponent(const unsigned char* bytes, size_t axis, int type, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return component<int8_t>(bytes, axis, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return component<uint8_t>(bytes, axis, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return component<int16_t>(bytes, axis, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return component<uint16_t>(bytes, axis, normalized);
        default:
            return load<float>(bytes + axis * sizeof(float));
    }
}

// The same index, if the accessor's type is one of a position's.
int checkedPositions(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors[size_t(index)];
    if (accessor.type != TINYGLTF_TYPE_VEC3) refuseGltf(nameOf(index) + " must be of type VEC3");
    if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT &&
        accessor.componentType > TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
        refuseGltf(nameOf(index) + " holds positions, and they are neither floats nor integers of 8 or 16 bits");
    return index;
}

}  // namespace

bool hasBytes(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors[size_t(index)];
    auto present = [&](int view) { return !model.buffers[size_t(viewOf(model, view).buffer)].data.empty(); };
    if (accessor.bufferView >= 0 && !present(accessor.bufferView)) return false;
    return !accessor.sparse.isSparse ||
           (present(accessor.sparse.indices.bufferView) && present(accessor.sparse.values.bufferView));
}

AccessorElements::AccessorElements(const tinygltf::Model& model, int index) : where_(nameOf(index)) {
    const tinygltf::Accessor& accessor = model.accessors[size_t(index)];
    const size_t size = elementSizeOf(accessor, where_);
    base_.count = accessor.count;
    if (accessor.bufferView >= 0)
        base_ = checkedBytes(model, accessor.bufferView, accessor.byteOffset, accessor.count, size, true, where_);
    if (accessor.sparse.isSparse) readSparse(model, accessor, size);
}

void AccessorElements::readSparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                                  size_t elementSize) {
    const auto& sparse = accessor.sparse;
    const size_t count = size_t(sparse.count);
    const int indexSize = tinygltf::GetComponentSizeInBytes(uint32_t(sparse.indices.componentType));
    if (indexSize <= 0) refuseGltf(where_ + ".sparse.indices has a type that is not known");
    const StridedBytes indices = checkedBytes(model, sparse.indices.bufferView, size_t(sparse.indices.byteOffset),
                                              count, size_t(indexSize), false, where_ + ".sparse.indices");
    sparseValues_ = checkedBytes(model, sparse.values.bufferView, size_t(sparse.values.byteOffset), count, elementSize,
                                 false, where_ + ".sparse.values");
    for (size_t i = 0; i < count; ++i) {
        sparseIndices_.push_back(loadIndex(indices.at(i), sparse.indices.componentType, where_ + ".sparse"));
        if (sparseIndices_[i] >= base_.count || (i > 0 && sparseIndices_[i] <= sparseIndices_[i - 1]))
            refuseGltf(where_ + ".sparse has indices that do not increase, or reach past its end");
    }
}

const unsigned char* AccessorElements::operator[](size_t i) const {
    const auto found = std::lower_bound(sparseIndices_.begin(), sparseIndices_.end(), i);
    if (found != sparseIndices_.end() && *found == i) return sparseValues_.at(size_t(found - sparseIndices_.begin()));
    return base_.data == nullptr ? nullptr : base_.at(i);
}

Positions::Positions(const tinygltf::Model& model, int index)
    : elements_(model, checkedPositions(model, index)),
      componentType_(model.accessors[size_t(index)].componentType),
      normalized_(model.accessors[size_t(index)].normalized) {}

glm::dvec3 Positions::operator[](size_t i) const {
    const unsigned char* bytes = elements_[i];
    if (bytes == nullptr) return glm::dvec3(0.0);
    return {positionComponent(bytes, 0, componentType_, normalized_),
            positionComponent(bytes, 1, componentType_, normalized_),
            positionComponent(bytes, 2, componentType_, normalized_)};
}

VertexIndices::VertexIndices(const tinygltf::Model& model, int index, size_t vertexCount) : count_(vertexCount) {
    if (index < 0) return;
    const tinygltf::Accessor& accessor = model.accessors[size_t(index)];
    if (accessor.type != TINYGLTF_TYPE_SCALAR) refuseGltf(nameOf(index) + " must be of type SCALAR");
    const AccessorElements elements(model, index);
    count_ = elements.count();
    indices_.resize(count_);
    for (size_t i = 0; i < count_; ++i) {
        const unsigned char* bytes = elements[i];
        indices_[i] = bytes == nullptr ? 0 : loadIndex(bytes, accessor.componentType, nameOf(index));
        if (indices_[i] >= vertexCount)
            refuseGltf(nameOf(index) + " holds the index " + std::to_string(indices_[i]) + ", and there are " +
                       std::to_string(vertexCount) + " vertices");
    }
}

}  // namespace cleave
