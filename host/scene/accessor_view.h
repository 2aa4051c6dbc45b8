// Views of the elements of accessors, which decode them one by one: a huge count costs nothing until it is read.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace cleave {

// Elements of one size, `stride` bytes apart, all proven to lie within their buffer.
struct StridedBytes {
    const unsigned char* data = nullptr;  // null: all zeros
    size_t count = 0;
    size_t stride = 0;
    const unsigned char* at(size_t i) const { return data + i * stride; }
};

// Elements of an accessor with sparse substitution (glTF 2.0, section 3.6.2.3). The scene outlives the view.
class AccessorElements {
  public:
    // Throws Error if the elements are not all there.
    AccessorElements(const Scene& scene, uint32_t accessor);
    size_t count() const { return base_.count; }
    // Returns the bytes of an element; null stands for zeros.
    const unsigned char* operator[](size_t i) const;

  private:
    void readSparse(const Scene& scene, const gltf::Accessor& accessor, size_t elementSize);

    std::string where_;
    StridedBytes base_;
    StridedBytes sparseValues_;
    std::vector<uint32_t> sparseIndices_;  // ascending
};

// Elements as doubles; integers are brought to [-1, 1] or [0, 1] where the accessor is normalised.
class AccessorValues {
  public:
    AccessorValues(const Scene& scene, uint32_t accessor);
    size_t count() const { return elements_.count(); }
    double scalar(size_t i) const;
    glm::dvec2 vec2(size_t i) const;
    glm::dvec3 vec3(size_t i) const;
    glm::dvec4 vec4(size_t i) const;
    glm::dmat4 mat4(size_t i) const;  // of floats

  private:
    AccessorElements elements_;
    gltf::ComponentType type_;
    bool normalized_;
};

// Elements of four whole numbers, such as numbers of joints.
class AccessorIntegers {
  public:
    AccessorIntegers(const Scene& scene, uint32_t accessor);
    size_t count() const { return elements_.count(); }
    glm::uvec4 operator[](size_t i) const;

  private:
    AccessorElements elements_;
    gltf::ComponentType type_;
};

// Vertex numbers of a primitive: those of an accessor, each proven to be below vertexCount, or 0, 1, 2, ...
class VertexIndices {
  public:
    VertexIndices(const Scene& scene, gltf::Index accessor, size_t vertexCount);
    size_t operator[](size_t i) const { return indices_.empty() ? i : indices_[i]; }

  private:
    std::vector<uint32_t> indices_;
};

}  // namespace cleave
