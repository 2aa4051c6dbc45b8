// The formats of accessors: how large their elements are, and which ones a use allows.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/check_values.h"
#include "scene/gltf.h"

namespace cleave {

gltf::ElementType elementTypeOf(const Json& accessor);
bool isComponentType(uint64_t number);

// Return the bytes of one component, and of one element; 0 if the type is not known. Columns of matrices begin at
// multiples of four bytes (glTF 2.0, section 3.6.2.4).
size_t componentSize(gltf::ComponentType type);
size_t elementSize(gltf::ElementType type, gltf::ComponentType component);

// Returns how many elements fit into the `length` bytes of a bufferView from `offset` on.
uint64_t fittingElements(uint64_t length, uint64_t offset, uint64_t stride, uint64_t elementSize);

// The formats that a use of an accessor allows.
struct Format {
    gltf::ElementType type;
    std::vector<gltf::ComponentType> components;
    const char* words;  // for messages: "VEC3 of floats"
};
extern const Format kPositionFormat, kIndexFormat, kJointsFormat, kWeightsFormat, kMatrixFormat, kTimeFormat,
    kVec3Format, kRotationFormat, kScalarFormat;

// Throws Error unless `value` is the index of an accessor in that format, which is returned.
const Json& checkAccessorValue(const Json& document, const Json& value, const Format& format, const std::string& where);

// Returns the count of a checked accessor.
uint64_t countOf(const Json& accessor);

}  // namespace cleave
