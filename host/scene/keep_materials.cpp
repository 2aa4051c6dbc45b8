// Keeps materials, textures, samplers and images.
#include <algorithm>
#include <array>
#include <limits>

#include "scene/gltf_keep.h"
#include "scene/keep_values.h"

namespace cleave {
namespace {

std::optional<gltf::TextureUse> textureUseOf(const Json& object, const char* name) {
    const Json* source = member(object, name);
    if (source == nullptr) return std::nullopt;
    gltf::TextureUse use;
    use.texture = *indexOf(*source, "index");
    use.texCoord = uint32_t(wholeOf(*source, "texCoord"));
    if (const Json* transform = extensionOf(*source, "KHR_texture_transform", "")) {
        use.texCoord = uint32_t(wholeOf(*transform, "texCoord", use.texCoord));
        use.offset = vectorOf<2>(*transform, "offset", use.offset);
        use.rotation = numberOf(*transform, "rotation", 0.0);
        use.scale = vectorOf<2>(*transform, "scale", use.scale);
    }
    return use;
}

constexpr double kLargest = std::numeric_limits<float>::max();

// Reads the factor of a texture, which is a member of the texture's use.
float factorOf(const Json& object, const char* texture, const char* name, double least, double most) {
    const Json* use = member(object, texture);
    return use == nullptr ? 1.0f : float(clampedOf(*use, name, 1.0, least, most));
}

void keepMetallicRoughness(const Json& source, gltf::Material& material) {
    const glm::dvec4 colour = vectorOf<4>(source, "baseColorFactor", glm::dvec4(1.0));
    for (int i = 0; i < 4; ++i) material.baseColour[i] = float(std::clamp(colour[i], 0.0, 1.0));
    material.metallic = float(clampedOf(source, "metallicFactor", 1.0, 0.0, 1.0));
    material.roughness = float(clampedOf(source, "roughnessFactor", 1.0, 0.0, 1.0));
    material.baseColourTexture = textureUseOf(source, "baseColorTexture");
    material.metallicRoughnessTexture = textureUseOf(source, "metallicRoughnessTexture");
}

gltf::AlphaMode alphaModeOf(const Json& source, const std::string& where, Warnings& warnings) {
    const std::string mode = textOf(source, "alphaMode");
    if (mode == "MASK") return gltf::AlphaMode::mask;
    if (mode == "BLEND") return gltf::AlphaMode::blend;
    if (!mode.empty() && mode != "OPAQUE") warnings.add(where + ".alphaMode is not known: it is taken as OPAQUE");
    return gltf::AlphaMode::opaque;
}

gltf::Material materialOf(const Json& source, const std::string& where, Warnings& warnings) {
    gltf::Material material;
    material.name = textOf(source, "name");
    if (const Json* pbr = member(source, "pbrMetallicRoughness")) keepMetallicRoughness(*pbr, material);
    material.emissive = glm::vec3(glm::clamp(vectorOf<3>(source, "emissiveFactor", glm::dvec3(0.0)), 0.0, 1.0));
    if (const Json* emissive = extensionOf(source, "KHR_materials_emissive_strength", ""))
        material.emissiveStrength = float(clampedOf(*emissive, "emissiveStrength", 1.0, 0.0, kLargest));
    material.normalScale = factorOf(source, "normalTexture", "scale", -kLargest, kLargest);
    material.occlusionStrength = factorOf(source, "occlusionTexture", "strength", 0.0, 1.0);
    material.normalTexture = textureUseOf(source, "normalTexture");
    material.occlusionTexture = textureUseOf(source, "occlusionTexture");
    material.emissiveTexture = textureUseOf(source, "emissiveTexture");
    material.alphaMode = alphaModeOf(source, where, warnings);
    material.alphaCutoff = float(clampedOf(source, "alphaCutoff", 0.5, 0.0, kLargest));
    material.doubleSided = boolOf(source, "doubleSided");
    material.unlit = extensionOf(source, "KHR_materials_unlit", "") != nullptr;
    return material;
}

// Reads a number of an enumeration. If it is none of `known`, a warning says so, and `fallback` is taken.
template <typename Enum, size_t N>
Enum oneOf(const std::array<Enum, N>& known, const Json& source, const char* name, Enum fallback,
           const std::string& where, Warnings& warnings) {
    const Json* value = member(source, name);
    if (value == nullptr) return fallback;
    const auto number = Enum(value->get<int>());
    if (std::find(known.begin(), known.end(), number) != known.end()) return number;
    warnings.add(where + "." + name + " is " + value->dump() + ", which is not known: the default is taken");
    return fallback;
}

gltf::Sampler samplerOf(const Json& source, const std::string& where, Warnings& warnings) {
    using gltf::Filter;
    using gltf::Wrap;
    constexpr std::array kMag = {Filter::nearest, Filter::linear};
    constexpr std::array kMin = {Filter::nearest,
                                 Filter::linear,
                                 Filter::nearestMipmapNearest,
                                 Filter::linearMipmapNearest,
                                 Filter::nearestMipmapLinear,
                                 Filter::linearMipmapLinear};
    constexpr std::array kWrap = {Wrap::clampToEdge, Wrap::mirroredRepeat, Wrap::repeat};
    return {oneOf(kMag, source, "magFilter", Filter::unspecified, where, warnings),
            oneOf(kMin, source, "minFilter", Filter::unspecified, where, warnings),
            oneOf(kWrap, source, "wrapS", Wrap::repeat, where, warnings),
            oneOf(kWrap, source, "wrapT", Wrap::repeat, where, warnings)};
}

}  // namespace

void keepMaterials(const Json& document, Scene& scene, Warnings& warnings) {
    const Json& materials = objectsOf(document, "materials");
    for (size_t i = 0; i < materials.size(); ++i)
        scene.materials.push_back(materialOf(materials[i], at("materials", i), warnings));
    scene.materials.emplace_back();
    scene.materials.back().name = "default";
    for (const Json& texture : objectsOf(document, "textures"))
        scene.textures.push_back({textOf(texture, "name"), indexOf(texture, "source"), indexOf(texture, "sampler")});
    const Json& samplers = objectsOf(document, "samplers");
    for (size_t i = 0; i < samplers.size(); ++i)
        scene.samplers.push_back(samplerOf(samplers[i], at("samplers", i), warnings));
    for (const Json& image : objectsOf(document, "images"))
        scene.images.push_back(
            {textOf(image, "name"), textOf(image, "uri"), textOf(image, "mimeType"), indexOf(image, "bufferView")});
}

}  // namespace cleave
