// glTF files for tests, made from their parts and loaded from a folder that is removed again.
#pragma once

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/pose.h"

namespace cleave::test {

using Json = nlohmann::json;

class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "cleave_scene_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw Error("no temporary folder can be made");
        path_ = name;
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

// The bytes of numbers, one after the other.
template <typename Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

inline std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

// A document with one scene, whose parts tests add and spoil.
class Document {
  public:
    Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
    std::string data;  // of buffer 0

    int addView(const std::string& bytes, int stride = 0) {
        while (data.size() % 4 != 0) data += '\0';
        Json view = {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}};
        if (stride != 0) view["byteStride"] = stride;
        data += bytes;
        json["bufferViews"].push_back(view);
        return int(json["bufferViews"].size()) - 1;
    }
    int addAccessor(int view, int componentType, size_t count, const char* type, const Json& more = Json::object()) {
        Json accessor = {{"componentType", componentType}, {"count", count}, {"type", type}};
        if (view >= 0) accessor["bufferView"] = view;
        accessor.update(more);
        json["accessors"].push_back(accessor);
        return int(json["accessors"].size()) - 1;
    }
    int addPositions(const std::vector<float>& xyz) {
        return addAccessor(addView(bytesOf(xyz)), 5126, xyz.size() / 3, "VEC3");
    }
    template <typename Index>
    int addIndices(const std::vector<Index>& indices) {
        const int type = sizeof(Index) == 1 ? 5121 : sizeof(Index) == 2 ? 5123 : 5125;
        return addAccessor(addView(bytesOf(indices)), type, indices.size(), "SCALAR");
    }
    // A mesh of one primitive, and a node that shows it.
    void addMesh(int positions, int indices = -1, const Json& more = Json::object()) {
        Json primitive = {{"attributes", {{"POSITION", positions}}}};
        if (indices >= 0) primitive["indices"] = indices;
        primitive.update(more);
        json["meshes"].push_back({{"primitives", {primitive}}});
        json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    }
    Json& node(size_t i = 0) { return json["nodes"][i]; }
    Json& primitive() { return json["meshes"][0]["primitives"][0]; }

    std::string text() const {
        Json copy = json;
        if (!data.empty() && !copy.contains("buffers"))
            copy["buffers"] = {
                {{"byteLength", data.size()}, {"uri", "data:application/octet-stream;base64," + base64(data)}}};
        return copy.dump();
    }
    std::string glb() const {
        Json copy = json;
        std::string bytes = data;
        while (bytes.size() % 4 != 0) bytes += '\0';
        copy["buffers"] = {{{"byteLength", data.size()}}};
        std::string body = copy.dump();
        while (body.size() % 4 != 0) body += ' ';
        auto word = [](size_t value) { return bytesOf(std::vector<uint32_t>{uint32_t(value)}); };
        return "glTF" + word(2) + word(28 + body.size() + bytes.size()) + word(body.size()) + "JSON" + body +
               word(bytes.size()) + std::string("BIN\0", 4) + bytes;
    }
};

// One triangle (0,0,0), (1,0,0), (0,1,0), not indexed.
inline Document triangleDocument() {
    Document document;
    document.addMesh(document.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    return document;
}

inline Scene sceneOf(const std::string& text, const std::string& name = "scene.gltf",
                     Reading reading = Reading::shown) {
    const Folder folder;
    return loadGltf(folder.write(name, text), reading);
}
inline Scene sceneOf(const Document& document) { return sceneOf(document.text()); }

// The rest pose of a scene, with the warnings of loading it as well.
inline PosedScene posed(const Scene& scene) {
    PosedScene result = pose(scene);
    result.warnings.insert(result.warnings.begin(), scene.warnings.begin(), scene.warnings.end());
    return result;
}
inline PosedScene loadText(const std::string& text, const std::string& name = "scene.gltf") {
    return posed(sceneOf(text, name));
}
inline PosedScene load(const Document& document) { return loadText(document.text()); }

// The message of the Error that loading or posing throws; empty if neither throws one.
inline std::string refusal(const std::string& text, const std::string& name = "scene.gltf") {
    try {
        loadText(text, name);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}
inline std::string refusal(const Document& document) { return refusal(document.text()); }

// The x of every vertex: enough to tell vertices apart that lie at (0, y, z), (1, y, z), (2, y, z), ...
inline std::vector<float> xOf(const PosedScene& scene) {
    std::vector<float> xs;
    for (const Triangle& t : scene.triangles) xs.insert(xs.end(), {t.a.x, t.b.x, t.c.x});
    return xs;
}

inline bool mentions(const std::vector<std::string>& warnings, const std::string& part) {
    for (const std::string& warning : warnings)
        if (warning.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace cleave::test
