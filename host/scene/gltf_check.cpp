#include "scene/gltf_check.h"

#include <array>

#include "scene/refuse.h"

namespace cleave {
namespace {

void checkVersion(const Json& document) {
    const Json& asset = requiredObject(document, "asset", "the file");
    const Json* version = member(asset, "version");
    if (version == nullptr || !version->is_string() || !version->get<std::string>().starts_with("2."))
        refuseGltf("asset.version is " + (version == nullptr ? "missing" : version->dump()) + ", and must be 2.x",
                   "convert it to glTF 2.0");
    const Json* least = member(asset, "minVersion");
    if (least != nullptr && *least != "2.0")
        refuseGltf("asset.minVersion is " + least->dump() + ", and 2.0 is what is understood",
                   "convert it to glTF 2.0");
}

// Those that say where surfaces are, which are read; the others change how they look.
bool isKnownExtension(const std::string& name) {
    constexpr std::array kKnown = {
        "KHR_mesh_quantization",   "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
        "EXT_mesh_gpu_instancing", "KHR_texture_transform",      "KHR_texture_basisu",      "EXT_texture_webp",
        "EXT_texture_avif",        "KHR_lights_punctual",        "KHR_xmp_json_ld"};
    for (const char* known : kKnown)
        if (name == known) return true;
    return name.starts_with("KHR_materials_");
}

void checkExtensions(const Json& document) {
    for (const Json& name : arrayOf(document, "extensionsRequired", "")) {
        if (!name.is_string()) refuseGltf("extensionsRequired holds " + name.dump() + ", which is no name");
        if (!isKnownExtension(name.get<std::string>()))
            refuseGltf("it requires the extension " + name.get<std::string>() + ", which is not supported",
                       "export it without that extension");
    }
}

}  // namespace

void checkGltf(const Json& document) {
    checkVersion(document);
    checkExtensions(document);
    checkBuffers(document);
    checkAccessors(document);
    checkMeshes(document);
    checkNodes(document);
    checkScenes(document);
    checkSkins(document);
    checkCameras(document);
    checkLights(document);
    checkImages(document);
    checkTextures(document);
    checkMaterials(document);
    checkAnimations(document);
}

}  // namespace cleave
