// loadGltf: read -> check -> keep, and the payload of the buffers that are needed, decompressed.
#include "scene/decompress.h"
#include "scene/gltf_check.h"
#include "scene/gltf_file.h"
#include "scene/gltf_keep.h"
#include "scene/read_buffers.h"
#include "scene/refuse.h"
#include "scene/shown_parts.h"
#include "scene/triangle_count.h"

namespace cleave {
namespace {

Scene sceneOf(GltfFile file, size_t mostTriangles, Reading reading) {
    checkGltf(file.document);
    Warnings warnings;
    Scene scene = keepGltf(file.document, warnings);
    scene.name = file.path.string();
    scene.folder = file.path.parent_path();
    checkImageFiles(scene, warnings);
    const ShownParts shown = shownParts(scene);
    const ShownParts read = reading == Reading::shown ? shown : allParts(scene);
    scene.unusedMeshes = unusedMeshes(shown);
    scene.unusedBuffers = unusedBuffers(scene, shown);
    readBuffers(file, scene, read, warnings);
    decompress(scene, read, mostTriangles);
    countTriangles(scene, mostTriangles);
    scene.warnings = warnings.list();
    return scene;
}

std::string failedToLoad(const std::filesystem::path& file) { return "cannot load '" + file.string() + "'"; }

}  // namespace

Scene loadGltf(const std::filesystem::path& file, Reading reading) {
    return naming(failedToLoad(file), [&] {
        GltfFile parsed = parseGltfFile(file, readBytes(file));  // the bytes of the file are freed here
        return sceneOf(std::move(parsed), kMostTriangles, reading);
    });
}

Scene loadGltf(const std::filesystem::path& file, std::span<const unsigned char> bytes, size_t mostTriangles,
               Reading reading) {
    return naming(failedToLoad(file), [&] { return sceneOf(parseGltfFile(file, bytes), mostTriangles, reading); });
}

}  // namespace cleave
