// Decompresses a mesh by Draco, and holds what comes out against what was announced.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf.h"

namespace cleave {

// An attribute that is asked for, and the form that it shall have.
struct DracoAttribute {
    uint32_t id = 0;
    gltf::ComponentType type = gltf::ComponentType::float32;
    size_t components = 0;
    std::string name;  // for messages
};

// What a document announces.
struct DracoRequest {
    std::optional<uint64_t> indices;
    std::optional<uint64_t> vertices;
    std::vector<DracoAttribute> attributes;
    size_t mostBytes = 0;  // that may be used while decompressing
};

struct DracoMesh {
    std::vector<uint32_t> indices;                       // three for each triangle, below the number of vertices
    std::vector<std::vector<unsigned char>> attributes;  // as asked for, of each vertex, packed
    size_t vertices = 0;
};

// Throws Error if the bytes are no Draco mesh of version 2.2, or not what was announced. Counts are compared before
// anything of their size is allocated. `where` names it in messages.
DracoMesh decompressDracoMesh(std::span<const unsigned char> bytes, const DracoRequest& request,
                              const std::string& where);

}  // namespace cleave
