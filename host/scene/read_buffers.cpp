#include "scene/read_buffers.h"

#include "scene/check_values.h"
#include "scene/gltf_uri.h"
#include "scene/instances.h"
#include "scene/uri_bytes.h"

namespace cleave {
namespace {

enum class Need { none, view, geometry };

class Needs {
  public:
    Needs(const Scene& scene, const ShownParts& read) : scene_(scene), needs_(scene.buffers.size(), Need::none) {
        for (size_t i = 0; i < scene.bufferViews.size(); ++i)
            if (read.views[i]) needs_[payloadBuffer(scene.bufferViews[i])] = Need::view;
        for (size_t i = 0; i < scene.meshes.size(); ++i) {
            if (!read.meshes[i]) continue;
            for (const gltf::Primitive& primitive : scene.meshes[i].primitives) addPrimitive(primitive);
        }
        for (const gltf::Node& node : scene.nodes)
            if (node.instancing)
                for (const gltf::Index accessor : accessorsOf(*node.instancing))
                    if (accessor) addAccessor(*accessor);
        for (const gltf::Skin& skin : scene.skins)
            if (skin.inverseBindMatrices) addAccessor(*skin.inverseBindMatrices);
    }
    Need operator[](size_t buffer) const { return needs_[buffer]; }

  private:
    void addView(uint32_t view) { needs_[payloadBuffer(scene_.bufferViews[view])] = Need::geometry; }
    void addAccessor(uint32_t index) {
        const gltf::Accessor& accessor = scene_.accessors[index];
        if (accessor.view) addView(*accessor.view);
        if (!accessor.sparse) return;
        addView(accessor.sparse->indicesView);
        addView(accessor.sparse->valuesView);
    }
    void addAttributes(const gltf::Attributes& attributes, const std::optional<gltf::Draco>& draco) {
        for (const auto& [semantic, accessor] : attributes)
            if (!(draco && draco->ids.contains(semantic)) &&
                (semantic == "POSITION" || semantic.starts_with("JOINTS_") || semantic.starts_with("WEIGHTS_")))
                addAccessor(accessor);
    }
    void addPrimitive(const gltf::Primitive& primitive) {
        addAttributes(primitive.attributes, primitive.draco);
        for (const gltf::Attributes& target : primitive.targets) addAttributes(target, std::nullopt);
        if (primitive.draco) addView(primitive.draco->view);
        if (primitive.indices && !primitive.draco) addAccessor(*primitive.indices);
    }

    const Scene& scene_;
    std::vector<Need> needs_;
};

std::vector<unsigned char> bytesOf(GltfFile& file, size_t index, uint64_t byteLength) {
    const Json& buffer = file.document["buffers"][index];
    const Json* uri = member(buffer, "uri");
    std::vector<unsigned char> bytes =
        uri != nullptr ? bytesOfUri(file.path.parent_path(), uri->get<std::string>()) : std::move(file.data);
    if (bytes.size() < byteLength)
        refuseGltf(at("buffers", index) + " has " + std::to_string(bytes.size()) + " bytes, and byteLength says " +
                   std::to_string(byteLength));
    bytes.resize(byteLength);
    return bytes;
}

// A path that leaves the folder is refused also where nothing is read.
void checkUri(const GltfFile& file, size_t index) {
    const Json* uri = member(file.document["buffers"][index], "uri");
    if (uri == nullptr) return;
    const std::string text = uri->get<std::string>();
    if (!isDataUri(text) && !isExternalUri(text)) pathOfUri(file.path.parent_path(), text);
}

}  // namespace

void readBuffers(GltfFile& file, Scene& scene, const ShownParts& read, Warnings& warnings) {
    const Needs needs(scene, read);
    for (size_t i = 0; i < scene.buffers.size(); ++i) {
        gltf::Buffer& buffer = scene.buffers[i];
        const bool hasUri = file.document["buffers"][i].contains("uri");
        const bool isChunk = i == 0 && file.hasData && !hasUri;
        const Need need = isChunk ? Need::geometry : needs[i];  // a chunk is part of the file, so it must be whole
        if (need != Need::geometry) checkUri(file, i);
        if (need == Need::none || (!hasUri && !isChunk)) continue;
        try {
            buffer.bytes = bytesOf(file, i, buffer.byteLength);
        } catch (const Error& error) {
            if (need == Need::geometry) throw;
            warnings.add(at("buffers", i) +
                         " is left out, with the images and animations that need it: " + error.what());
        }
    }
}

void checkImageFiles(const Scene& scene, Warnings& warnings) {
    for (const gltf::Image& image : scene.images) {
        if (image.uri.empty() || isDataUri(image.uri)) continue;
        std::error_code failed;
        if (!std::filesystem::exists(pathOfUri(scene.folder, image.uri), failed))
            warnings.add("the image '" + image.uri + "' does not exist");
    }
}

}  // namespace cleave
