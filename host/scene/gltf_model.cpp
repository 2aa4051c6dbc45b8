#include "scene/gltf_model.h"

#include <algorithm>
#include <array>

#include "scene/gltf_check.h"
#include "scene/gltf_uri.h"

namespace cleave {
namespace {

using Json = nlohmann::json;

void checkImages(const GltfFile& file, std::vector<std::string>& warnings) {
    for (const Json& image : objectsOf(file.document, "images")) {
        const auto uri = image.find("uri");
        if (uri == image.end() || !uri->is_string() || isDataUri(uri->get<std::string>())) continue;
        const auto path = pathOfUri(file.path.parent_path(), uri->get<std::string>());
        std::error_code failed;
        if (!std::filesystem::exists(path, failed))
            warnings.push_back("the image '" + uri->get<std::string>() + "' does not exist");
    }
}

// Buffers that some bufferView names: others need not even exist.
std::vector<bool> usedBuffers(const Json& document) {
    std::vector<bool> used(objectsOf(document, "buffers").size(), false);
    for (const Json& view : objectsOf(document, "bufferViews")) used[view["buffer"].get<size_t>()] = true;
    return used;
}

std::vector<unsigned char> bytesOfUri(const GltfFile& file, const std::string& uri) {
    if (!isDataUri(uri)) return readBytes(pathOfUri(file.path.parent_path(), uri));
    std::vector<unsigned char> bytes;
    std::string mimeType;
    if (!tinygltf::IsDataURI(uri) || !tinygltf::DecodeDataURI(&bytes, mimeType, uri, 0, false))
        refuseGltf("the data URI '" + uri.substr(0, 40) + "...' cannot be decoded");
    return bytes;
}

std::vector<unsigned char> bufferBytes(GltfFile& file, size_t index, bool used) {
    const Json& buffer = file.document["buffers"][index];
    const auto uri = buffer.find("uri");
    const std::string where = "buffers[" + std::to_string(index) + "]";
    std::vector<unsigned char> bytes;
    if (uri == buffer.end()) {
        if (index != 0 || !file.hasData) return bytes;
        bytes = std::move(file.data);
    } else {
        const std::string text = uri->get<std::string>();
        // An unused buffer is not read, but a path that leaves the folder is refused all the same.
        if (!used && !isDataUri(text) && !isExternalUri(text)) pathOfUri(file.path.parent_path(), text);
        if (!used) return bytes;
        bytes = bytesOfUri(file, text);
    }
    const size_t announced = buffer["byteLength"].get<size_t>();
    if (bytes.size() < announced)
        refuseGltf(where + " has " + std::to_string(bytes.size()) + " bytes, and byteLength says " +
                   std::to_string(announced));
    bytes.resize(announced);
    return bytes;
}

// Gives every accessor a bufferView (an empty one, appended) and a type that tinygltf knows: it refuses files without,
// though both are valid. MAT2 is a type that no reader here takes.
void fillAccessors(Json& document) {
    const auto accessors = document.find("accessors");
    if (accessors == document.end()) return;
    const size_t views = objectsOf(document, "bufferViews").size();
    document["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 0}});
    constexpr std::array kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    for (Json& accessor : *accessors) {
        if (!accessor.contains("bufferView")) accessor["bufferView"] = views;
        const auto type = accessor.find("type");
        if (type == accessor.end() || std::find(kTypes.begin(), kTypes.end(), *type) == kTypes.end())
            accessor["type"] = "MAT2";
    }
}

// What geometry does not need, tinygltf does not get to see: it reads image files wherever their URIs point, and walks
// animations and extras without checking them. Buffers are read here.
void dropUnneeded(Json& document) {
    for (const char* name :
         {"images", "textures", "samplers", "animations", "skins", "extensions", "extras", "buffers"})
        document.erase(name);
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

tinygltf::Model parseModel(Json document) {
    std::vector<bool> hasView;
    for (const Json& accessor : objectsOf(document, "accessors")) hasView.push_back(accessor.contains("bufferView"));
    dropUnneeded(document);
    fillAccessors(document);
    const std::string text = document.dump();
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    try {
        if (!loader.LoadASCIIFromString(&model, &error, &warning, text.c_str(), unsigned(text.size()), ""))
            refuseGltf("it cannot be read: " + firstLine(error));
    } catch (const nlohmann::json::exception& e) {
        refuseGltf(std::string("it cannot be read: ") + e.what());
    } catch (const std::out_of_range& e) {
        refuseGltf(std::string("it cannot be read: ") + e.what());
    }
    // The stand-ins are taken back: -1 means that the accessor is all zeros but for its sparse part.
    for (size_t i = 0; i < hasView.size(); ++i)
        if (!hasView[i]) model.accessors[i].bufferView = -1;
    return model;
}

}  // namespace

tinygltf::Model loadModel(GltfFile file, std::vector<std::string>& warnings) {
    checkGltf(file.document);
    checkImages(file, warnings);
    tinygltf::Model model = parseModel(file.document);
    const std::vector<bool> used = usedBuffers(file.document);
    model.buffers.resize(used.size());
    for (size_t i = 0; i < used.size(); ++i) model.buffers[i].data = bufferBytes(file, i, used[i]);
    return model;
}

}  // namespace cleave
