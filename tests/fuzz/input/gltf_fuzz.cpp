// Any bytes are a scene or an Error of one line: no crash, no leak, nothing read outside of the scene's folder.
#include <sys/inotify.h>
#include <unistd.h>

#include <cmath>

#include "base/error.h"
#include "harness.h"
#include "scene/scene.h"

namespace cleave::fuzz {
namespace {

// Far fewer than a user may load, so that a run is quick, and that the refusal is reached.
constexpr size_t kMostTriangles = size_t(1) << 15;

// Tells whether a file was opened since the last time.
class Watch {
  public:
    explicit Watch(const std::filesystem::path& file) : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        require(queue_ >= 0 && inotify_add_watch(queue_, file.c_str(), IN_OPEN) >= 0, "a file can be watched");
    }
    bool sawOpening() const {
        alignas(inotify_event) char events[4096];
        return read(queue_, events, sizeof events) > 0;
    }

  private:
    int queue_;
};

bool isUnit(const glm::dvec3& v) { return std::fabs(glm::length(v) - 1.0) < 1e-6; }

void requireSound(const Scene& scene) {
    require(scene.triangles.size() <= kMostTriangles, "the limit holds");
    require(scene.triangles.size() == scene.materialOf.size(), "each triangle has a material");
    for (const uint32_t material : scene.materialOf) require(material < scene.materials.size(), "a material exists");
    require(!scene.materials.empty(), "there is a default material");
    for (const Material& material : scene.materials)
        for (int i = 0; i < 4; ++i)
            require(material.baseColour[i] >= 0.0f && material.baseColour[i] <= 1.0f, "colours are in [0, 1]");
    for (const Camera& camera : scene.cameras)
        require(isUnit(camera.forward) && isUnit(camera.up) && std::fabs(glm::dot(camera.forward, camera.up)) < 1e-6,
                "a camera has directions", camera.name);
    for (const std::string& warning : scene.warnings) requireOneLine(warning);
}

}  // namespace
}  // namespace cleave::fuzz

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    const TimeLimit limit;
    static const SceneFolder folder;
    static const Watch outside(folder.outside());
    try {
        requireSound(cleave::loadGltf(folder.folder() / "scene.gltf", {data, size}, kMostTriangles));
    } catch (const cleave::Error& error) {
        requireOneLine(error.what());
    }
    require(!outside.sawOpening(), "no URI leaves the scene's folder");
    return 0;
}
