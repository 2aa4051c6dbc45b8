#include "cleave/scene.hpp"
#include "facade/copied.h"
#include "scene/pose.h"
#include "scene/scene.h"

namespace cleave::scene {

struct GltfFile::State {
    Scene scene;
};

GltfFile::GltfFile(const std::filesystem::path& file) : state_(std::make_unique<State>(State{loadGltf(file)})) {}

GltfFile::~GltfFile() = default;
GltfFile::GltfFile(GltfFile&&) noexcept = default;

const std::vector<std::string>& GltfFile::warnings() const { return state_->scene.warnings; }

Posed GltfFile::pose(std::optional<double> seconds, const std::string& animation) const {
    PoseTime time;
    time.seconds = seconds;
    if (seconds) time.animations = chooseAnimation(state_->scene, animation);
    PosedScene posed = cleave::pose(state_->scene, time);
    return {copied<Triangle>(std::span<const cleave::Triangle>(posed.triangles)), std::move(posed.warnings)};
}

}  // namespace cleave::scene
