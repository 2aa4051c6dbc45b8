// The scene files that tests run over: our own, and further ones beside the checkout where they are present.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "scene/pose.h"

namespace cleave::test {

// All of them, in order.
inline std::vector<std::filesystem::path> allSceneFiles() {
    const std::filesystem::path source = CLEAVE_SOURCE;
    std::vector<std::filesystem::path> files;
    for (const auto& folder : {source / "scenes", source / "../shared/scenes"}) {
        if (!std::filesystem::exists(folder)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            const auto extension = entry.path().extension();
            if (extension == ".glb" || extension == ".gltf") files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

// Files that can be loaded and have at most `mostTriangles`.
inline std::vector<std::filesystem::path> sceneFiles(size_t mostTriangles) {
    std::vector<std::filesystem::path> files = allSceneFiles();
    std::erase_if(files, [&](const std::filesystem::path& file) {
        try {
            return pose(loadGltf(file)).triangles.size() > mostTriangles;
        } catch (const Error& refused) {  // needs an extension that is not supported: the loader's tests look at that
            std::printf("left out: %s\n", refused.what());
            return true;
        }
    });
    return files;
}

}  // namespace cleave::test
