// A scene, kept as glTF has it. To see it at a time, pose it (pose.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf.h"

namespace cleave {

struct Scene {
    std::string name;              // what was loaded, for messages
    std::filesystem::path folder;  // where the URIs of images lead
    std::vector<gltf::Buffer> buffers;
    std::vector<gltf::BufferView> bufferViews;
    std::vector<gltf::Accessor> accessors;
    std::vector<gltf::Mesh> meshes;
    std::vector<gltf::Node> nodes;  // a forest
    std::vector<gltf::SceneRoots> scenes;
    gltf::Index defaultScene;
    std::vector<gltf::Skin> skins;
    std::vector<gltf::Material> materials;  // never empty: glTF's default material comes last
    std::vector<gltf::Texture> textures;
    std::vector<gltf::Image> images;
    std::vector<gltf::Sampler> samplers;
    std::vector<gltf::Light> lights;
    std::vector<gltf::Camera> cameras;
    std::vector<gltf::Animation> animations;
    // What the scene that is shown does not need; its payload is there only if everything was to be read.
    size_t unusedMeshes = 0;
    size_t unusedBuffers = 0;
    std::vector<std::string> warnings;  // what is wrong with the file but can be survived, a sentence each
};

// A small file can ask for any number of triangles, by instances. These take less than 2 GB while they are collected.
constexpr size_t kMostTriangles = size_t(1) << 25;

// What of a file's payload is read: what its default scene may show, with all of its images and animations; or all.
enum class Reading { shown, everything };

// Loads .gltf or .glb. Throws Error for what cannot be read or must not be trusted: sizes, indices and URIs are checked
// whether the scene shows what they belong to or not.
Scene loadGltf(const std::filesystem::path& file, Reading reading = Reading::shown);

// Loads the same from bytes in memory. `file` names them in messages, and its folder is where URIs lead. Throws Error
// if the scene shows more than `mostTriangles`.
Scene loadGltf(const std::filesystem::path& file, std::span<const unsigned char> bytes,
               size_t mostTriangles = kMostTriangles, Reading reading = Reading::shown);

}  // namespace cleave
