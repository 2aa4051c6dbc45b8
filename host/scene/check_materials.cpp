// Checks materials, textures, samplers and images.
#include "scene/gltf_check.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

void checkTextureUse(const Json& document, const Json& use, const std::string& where) {
    requireIndex(use, "index", targetOf(document, "textures"), where);
    checkCount(use, "texCoord", false, 1u << 16, where);
    checkNumber(use, "scale", false, where);
    checkNumber(use, "strength", false, where);
    const Json* transform = extensionOf(use, "KHR_texture_transform", where);
    if (transform == nullptr) return;
    const std::string name = where + ".extensions.KHR_texture_transform";
    checkNumbers(*transform, "offset", 2, name);
    checkNumbers(*transform, "scale", 2, name);
    checkNumber(*transform, "rotation", false, name);
    checkCount(*transform, "texCoord", false, 1u << 16, name);
}

// Checks every member of a material, or of a part or extension of it, that is called ...Texture.
void checkTextureUses(const Json& document, const Json& object, const std::string& where) {
    for (const auto& [name, value] : object.items()) {
        if (name == "extras") continue;
        if (name.ends_with("Texture"))
            checkTextureUse(document, *objectAt(object, name.c_str(), where), where + "." + name);
        else if (value.is_object())
            checkTextureUses(document, value, where + "." + name);
    }
}

void checkMaterial(const Json& document, const Json& material, const std::string& where) {
    checkTextureUses(document, material, where);
    checkNumbers(material, "emissiveFactor", 3, where);
    checkNumber(material, "alphaCutoff", false, where);
    checkText(material, "alphaMode", where);
    checkBool(material, "doubleSided", where);
    if (const Json* pbr = objectAt(material, "pbrMetallicRoughness", where)) {
        const std::string name = where + ".pbrMetallicRoughness";
        checkNumbers(*pbr, "baseColorFactor", 4, name);
        checkNumber(*pbr, "metallicFactor", false, name);
        checkNumber(*pbr, "roughnessFactor", false, name);
    }
    if (const Json* emissive = extensionOf(material, "KHR_materials_emissive_strength", where))
        checkNumber(*emissive, "emissiveStrength", false, where + ".extensions.KHR_materials_emissive_strength");
}

}  // namespace

void checkImages(const Json& document) {
    const Json& images = objectsOf(document, "images");
    for (size_t i = 0; i < images.size(); ++i) {
        const std::string where = at("images", i);
        const bool inBuffer = checkIndex(images[i], "bufferView", targetOf(document, "bufferViews"), where);
        checkText(images[i], "uri", where);
        checkText(images[i], "mimeType", where);
        if (const Json* uri = member(images[i], "uri"); uri != nullptr && *uri == "")
            refuseGltf(where + ".uri is empty");
        if (inBuffer && images[i].contains("uri")) refuseGltf(where + " has both a uri and a bufferView");
        if (inBuffer && !images[i].contains("mimeType")) refuseGltf(where + " has a bufferView, and no mimeType");
    }
}

void checkTextures(const Json& document) {
    const Json& samplers = objectsOf(document, "samplers");
    for (size_t i = 0; i < samplers.size(); ++i)
        for (const char* name : {"magFilter", "minFilter", "wrapS", "wrapT"})
            checkCount(samplers[i], name, false, 1u << 16, at("samplers", i));
    const Json& textures = objectsOf(document, "textures");
    for (size_t i = 0; i < textures.size(); ++i) {
        const std::string where = at("textures", i);
        checkIndex(textures[i], "source", targetOf(document, "images"), where);
        checkIndex(textures[i], "sampler", targetOf(document, "samplers"), where);
        const Json* extensions = objectAt(textures[i], "extensions", where);
        if (extensions == nullptr) continue;
        for (const auto& [name, extension] : extensions->items())  // further encodings of the same picture
            if (extension.is_object())
                checkIndex(extension, "source", targetOf(document, "images"), where + ".extensions." + name);
    }
}

void checkMaterials(const Json& document) {
    const Json& materials = objectsOf(document, "materials");
    for (size_t i = 0; i < materials.size(); ++i) checkMaterial(document, materials[i], at("materials", i));
}

}  // namespace cleave
