// Checked reading of accessors, element by element: nothing is copied, so a huge count costs nothing until it is read.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace cleave {

// Elements of one size, `stride` bytes apart, all proven to lie within their buffer.
struct StridedBytes {
    const unsigned char* data = nullptr;  // null: all zeros
    size_t count = 0;
    size_t stride = 0;
    const unsigned char* at(size_t i) const { return data + i * stride; }
};

// False if the bytes of an accessor (or of its sparse part) are in a buffer that the file does not come with.
bool hasBytes(const tinygltf::Model& model, int accessor);

// Elements of an accessor with sparse substitution (glTF 2.0, section 3.6.2.3).
class AccessorElements {
  public:
    AccessorElements(const tinygltf::Model& model, int accessor);
    size_t count() const { return base_.count; }
    // Null stands for an element of zeros.
    const unsigned char* operator[](size_t i) const;

  private:
    void readSparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor, size_t elementSize);

    std::string where_;
    StridedBytes base_;
    StridedBytes sparseValues_;
    std::vector<uint32_t> sparseIndices_;  // ascending
};

// POSITION: floats, or the integers of KHR_mesh_quantization, normalised or not.
class Positions {
  public:
    Positions(const tinygltf::Model& model, int accessor);
    size_t count() const { return elements_.count(); }
    glm::dvec3 operator[](size_t i) const;

  private:
    AccessorElements elements_;
    int componentType_;
    bool normalized_;
};

// Vertex numbers of a primitive: those of an accessor, each proven to be below vertexCount, or 0, 1, 2, ...
class VertexIndices {
  public:
    VertexIndices(const tinygltf::Model& model, int accessor, size_t vertexCount);  // accessor -1: none
    size_t count() const { return count_; }
    size_t operator[](size_t i) const { return indices_.empty() ? i : indices_[i]; }

  private:
    size_t count_;
    std::vector<uint32_t> indices_;
};

}  // namespace cleave
