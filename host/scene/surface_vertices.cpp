#include "scene/surface_vertices.h"

#include <algorithm>
#include <cmath>

#include "scene/triangle_count.h"

namespace cleave {
namespace {

using gltf::ComponentType;
using gltf::ElementType;

// glTF 2.0, section 3.7.2.1, and KHR_mesh_quantization.
bool isFormatOf(const std::string& semantic, const gltf::Accessor& accessor) {
    const ComponentType type = accessor.componentType;
    if (type == ComponentType::uint32) return false;
    const bool isSigned = type == ComponentType::int8 || type == ComponentType::int16;
    if (semantic == "NORMAL")
        return accessor.elementType == ElementType::vec3 && (isSigned || type == ComponentType::float32);
    if (semantic.starts_with("TEXCOORD_")) return accessor.elementType == ElementType::vec2;
    return (accessor.elementType == ElementType::vec3 || accessor.elementType == ElementType::vec4) && !isSigned;
}

double largestOf(const glm::dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

// A number may be finite in double and not in float.
float finiteFloat(double value) {
    const auto narrow = float(value);
    return std::isfinite(narrow) ? narrow : 0.0f;
}

}  // namespace

SurfaceVertices::SurfaceVertices(const Scene& scene, const gltf::Primitive& primitive, const Deformation& deformation,
                                 const std::string& where, Warnings& warnings) {
    const auto isUsable = [&](const std::string& semantic, uint32_t accessor) {
        const bool isFormat = isFormatOf(semantic, scene.accessors[accessor]);
        if (isFormat && hasBytes(scene, accessor)) return true;
        warnings.add(where + ": " + semantic + " is left out: " +
                     (isFormat ? "its data is in a buffer that is not there" : "it has a format that glTF does not"));
        return false;
    };
    const auto read = [&](const std::string& semantic) {
        const gltf::Index accessor = attributeOf(primitive.attributes, semantic);
        return accessor && isUsable(semantic, *accessor) ? std::optional(AccessorValues(scene, *accessor))
                                                         : std::nullopt;
    };
    normals_ = read("NORMAL");
    texCoords_ = {read("TEXCOORD_0"), read("TEXCOORD_1")};
    colours_ = read("COLOR_0");
    if (colours_)
        coloursHaveAlpha_ = scene.accessors[primitive.attributes.at("COLOR_0")].elementType == ElementType::vec4;
    if (!normals_) return;
    for (const MorphTarget& target : movingTargets(primitive, deformation, "NORMAL"))
        if (isUsable("NORMAL", target.deltas))
            normalTargets_.push_back({AccessorValues(scene, target.deltas), target.weight});
}

size_t SurfaceVertices::terms() const {
    return size_t(normals_.has_value()) + normalTargets_.size() + size_t(texCoords_[0].has_value()) +
           size_t(texCoords_[1].has_value()) + size_t(colours_.has_value());
}

glm::dvec3 SurfaceVertices::normal(size_t vertex) const {
    glm::dvec3 normal = normals_->vec3(vertex);
    for (const Target& target : normalTargets_) normal += target.weight * target.deltas.vec3(vertex);
    return normal;
}

glm::vec2 SurfaceVertices::texCoord(size_t set, size_t vertex) const {
    const glm::dvec2 value = texCoords_[set]->vec2(vertex);
    return {finiteFloat(value.x), finiteFloat(value.y)};
}

glm::vec4 SurfaceVertices::colour(size_t vertex) const {
    const glm::dvec4 value = coloursHaveAlpha_ ? colours_->vec4(vertex) : glm::dvec4(colours_->vec3(vertex), 1.0);
    glm::vec4 colour;
    for (int i = 0; i < 4; ++i) colour[i] = float(std::clamp(finite(value[i]), 0.0, 1.0));
    return colour;
}

// The columns of the cofactor matrix, which is the inverse transpose times the determinant. It is scaled first, since
// products of a matrix's elements may be too large or too small for a double.
glm::dmat3 normalMatrix(const glm::dmat4& m) {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) largest = std::max(largest, largestOf(glm::dvec3(m[column])));
    if (!(largest > 0.0) || !std::isfinite(largest)) return glm::dmat3(0.0);
    const glm::dvec3 x = glm::dvec3(m[0]) / largest;
    const glm::dvec3 y = glm::dvec3(m[1]) / largest;
    const glm::dvec3 z = glm::dvec3(m[2]) / largest;
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    return glm::dot(x, cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

glm::vec3 unitOrZero(const glm::dvec3& v) {
    const double largest = largestOf(v);
    if (!(largest > 0.0) || !std::isfinite(largest)) return glm::vec3(0.0f);
    const glm::dvec3 scaled = v / largest;  // its square neither overflows nor vanishes
    return glm::vec3(scaled / glm::length(scaled));
}

}  // namespace cleave
