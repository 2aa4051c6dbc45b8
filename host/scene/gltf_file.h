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

// Reads the bytes of a regular file.
std::vector<unsigned char> readBytes(const std::filesystem::path& path);

// Parses the bytes of the file `path`. The first four tell .glb from .gltf, as names may lie.
GltfFile parseGltfFile(const std::filesystem::path& path, std::span<const unsigned char> bytes);

}  // namespace cleave
