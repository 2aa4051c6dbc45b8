// The file itself: bytes on disk to a JSON document and the binary chunk of a .glb, both still untrusted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace cleave {

struct GltfFile {
    std::filesystem::path path;
    nlohmann::json document;          // an object
    std::vector<unsigned char> data;  // the BIN chunk of a .glb
    bool hasData = false;
};

// Throws what is wrong with a glTF file, without its name: loadGltf adds that, and the advice where there is none.
[[noreturn]] void refuseGltf(const std::string& what, const std::string& advice = "");

// The bytes of a regular file.
std::vector<unsigned char> readBytes(const std::filesystem::path& path);

// Tells .glb from .gltf by the first four bytes, as names may lie. `path` is where the bytes come from.
GltfFile parseGltfFile(const std::filesystem::path& path, std::span<const unsigned char> bytes);

// `text` fit for one line of output: control characters become spaces, and it is cut at a sensible length.
std::string oneLine(const std::string& text);

}  // namespace cleave
