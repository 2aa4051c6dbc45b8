#include "scene/check_format.h"

#include <algorithm>
#include <array>

#include "scene/refuse.h"

namespace cleave {
namespace {

using gltf::ComponentType;
using gltf::ElementType;

struct TypeName {
    const char* name;
    ElementType type;
    size_t columns;
    size_t rows;
};
constexpr std::array kTypes = {
    TypeName{"SCALAR", ElementType::scalar, 1, 1}, TypeName{"VEC2", ElementType::vec2, 1, 2},
    TypeName{"VEC3", ElementType::vec3, 1, 3},     TypeName{"VEC4", ElementType::vec4, 1, 4},
    TypeName{"MAT2", ElementType::mat2, 2, 2},     TypeName{"MAT3", ElementType::mat3, 3, 3},
    TypeName{"MAT4", ElementType::mat4, 4, 4},
};

const char* nameOf(ComponentType type) {
    switch (type) {
        case ComponentType::int8:
            return "8-bit integers";
        case ComponentType::uint8:
            return "8-bit integers without sign";
        case ComponentType::int16:
            return "16-bit integers";
        case ComponentType::uint16:
            return "16-bit integers without sign";
        case ComponentType::uint32:
            return "32-bit integers without sign";
        case ComponentType::float32:
            return "floats";
    }
    return "";
}

const std::vector<ComponentType> kFloatOrSmall = {ComponentType::float32, ComponentType::int8, ComponentType::uint8,
                                                  ComponentType::int16, ComponentType::uint16};

}  // namespace

const Format kPositionFormat = {ElementType::vec3, kFloatOrSmall, "VEC3 of floats or of integers of 8 or 16 bits"};
const Format kIndexFormat = {ElementType::scalar,
                             {ComponentType::uint8, ComponentType::uint16, ComponentType::uint32},
                             "SCALAR of integers without sign"};
const Format kJointsFormat = {
    ElementType::vec4, {ComponentType::uint8, ComponentType::uint16}, "VEC4 of integers of 8 or 16 bits without sign"};
const Format kWeightsFormat = {ElementType::vec4,
                               {ComponentType::float32, ComponentType::uint8, ComponentType::uint16},
                               "VEC4 of floats or of integers of 8 or 16 bits without sign"};
const Format kMatrixFormat = {ElementType::mat4, {ComponentType::float32}, "MAT4 of floats"};
const Format kTimeFormat = {ElementType::scalar, {ComponentType::float32}, "SCALAR of floats"};
const Format kVec3Format = {ElementType::vec3, {ComponentType::float32}, "VEC3 of floats"};
const Format kRotationFormat = {ElementType::vec4, kFloatOrSmall, "VEC4 of floats or of integers of 8 or 16 bits"};
const Format kScalarFormat = {ElementType::scalar, kFloatOrSmall, "SCALAR of floats or of integers of 8 or 16 bits"};

ElementType elementTypeOf(const Json& accessor) {
    const Json* name = member(accessor, "type");
    for (const TypeName& type : kTypes)
        if (name != nullptr && *name == type.name) return type.type;
    return ElementType::unknown;
}

bool isComponentType(uint64_t number) { return number >= 5120 && number <= 5126 && number != 5124; }

size_t componentSize(ComponentType type) {
    const bool isByte = type == ComponentType::int8 || type == ComponentType::uint8;
    const bool isShort = type == ComponentType::int16 || type == ComponentType::uint16;
    return isByte ? 1 : isShort ? 2 : 4;
}

size_t elementSize(ElementType type, ComponentType component) {
    for (const TypeName& known : kTypes) {
        if (known.type != type) continue;
        const size_t column = known.rows * componentSize(component);
        return known.columns == 1 ? column : known.columns * ((column + 3) / 4 * 4);
    }
    return 0;
}

uint64_t fittingElements(uint64_t length, uint64_t offset, uint64_t stride, uint64_t size) {
    const uint64_t rest = offset < length ? length - offset : 0;
    return rest < size ? 0 : (rest - size) / stride + 1;
}

const Json& checkAccessorValue(const Json& document, const Json& value, const Format& format,
                               const std::string& where) {
    checkIndexValue(value, targetOf(document, "accessors"), where);
    const size_t index = value.get<size_t>();
    const Json& accessor = document["accessors"][index];
    const auto component = ComponentType(accessor["componentType"].get<int>());
    const bool good =
        elementTypeOf(accessor) == format.type &&
        std::find(format.components.begin(), format.components.end(), component) != format.components.end();
    if (!good) {
        const Json* type = member(accessor, "type");
        refuseGltf(where + " is " + at("accessors", index) + ", which holds " +
                   (type == nullptr ? "no type" : type->dump()) + " of " + nameOf(component) + ", and must hold " +
                   format.words);
    }
    return accessor;
}

uint64_t countOf(const Json& accessor) { return accessor["count"].get<uint64_t>(); }

}  // namespace cleave
