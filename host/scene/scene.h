// A scene as the rest of the program sees it: numbered triangles in world space, and what a picture of them needs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "shared/triangle.h"

namespace cleave {

struct Material {
    std::string name;
    glm::vec4 baseColour{1.0f};  // linear RGBA, the base colour factor
};

// A glTF camera, placed in the world. Looks along -z of its node.
struct Camera {
    std::string name;
    glm::dvec3 eye{0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};  // unit length
    glm::dvec3 up{0.0, 1.0, 0.0};        // unit length, at a right angle to forward
    bool orthographic = false;
    double verticalFov = 0.0;         // radians; perspective only
    double orthographicHeight = 0.0;  // full height seen; orthographic only
};

struct Scene {
    std::string name;                         // what was loaded, for messages
    std::vector<Triangle> triangles;          // world space, in scene order: the index is the number of a triangle
    std::vector<uint32_t> materialOf;         // per triangle, an index into materials
    std::vector<Material> materials;          // never empty: glTF's default material comes last
    std::vector<Camera> cameras;              // in the order of the scene's nodes
    std::map<std::string, uint64_t> leftOut;  // what the loader left out ("points", "lines", ...) -> how many
    std::vector<std::string> warnings;        // what was wrong with the file but could be survived, a sentence each
};

// Loads .gltf or .glb. Triangles are numbered: default scene (or the first), nodes depth-first,
// primitives in order, triangles in index order. Throws Error for what cannot be read or must not be trusted:
// sizes, indices and URIs are checked before they are used.
Scene loadGltf(const std::filesystem::path& file);

// A small file can ask for any number of triangles, by instances. These take less than 2 GB while they are collected.
constexpr size_t kMostTriangles = size_t(1) << 25;

// The same from bytes in memory. `file` names them in messages, and its folder is where URIs lead. A scene of more than
// `mostTriangles` is refused.
Scene loadGltf(const std::filesystem::path& file, std::span<const unsigned char> bytes,
               size_t mostTriangles = kMostTriangles);

}  // namespace cleave
