// Reads a glTF file: its bytes become a JSON document and the binary chunk of a .glb, neither of them checked yet.
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

// The bytes of a regular file.
std::vector<unsigned char> readBytes(const std::filesystem::path& path);

// Tells .glb from .gltf by the first four bytes, as names may lie. `path` is where the bytes come from.
GltfFile parseGltfFile(const std::filesystem::path& path, std::span<const unsigned char> bytes);

}  // namespace cleave
