// The scene files that have animations: our own, and further ones beside the checkout where they are present.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "base/error.h"
#include "scene/animation.h"
#include "scene/scene.h"
#include "support/scene_files.h"

namespace cleave::test {

// Hands each of them to `look`, with some times from before the first key of all of its animations to after the last.
// Files that are refused are the loader's business.
inline void forAnimatedScenes(
    const std::function<void(const std::filesystem::path&, const Scene&, const std::vector<double>& times)>& look) {
    for (const std::filesystem::path& file : allSceneFiles()) {
        Scene scene;
        double end = 0.0;
        try {
            scene = loadGltf(file);
            end = endOf(scene, allAnimations(scene));
        } catch (const Error&) {
            continue;
        }
        if (!scene.animations.empty()) look(file, scene, {0.41 * end, -1.0, 0.0, 0.73 * end, end, 0.173 * end});
    }
}

}  // namespace cleave::test
