// Any bytes are a scene that can be posed at any time, or an Error of one line: no crash, no leak, nothing read outside
// of the scene's folder.
#include <sys/inotify.h>
#include <unistd.h>

#include <cmath>

#include "base/error.h"
#include "harness.h"
#include "scene/pose.h"

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

template <typename Value>
void requireFinite(const std::vector<Value>& values, const PosedScene& posed) {
    require(values.empty() || values.size() == 3 * posed.triangles.size(), "each corner has a value, or none has");
    for (const Value& value : values)
        for (int i = 0; i < Value::length(); ++i) require(std::isfinite(value[i]), "values of corners are finite");
}

void requireSoundCorners(const PosedScene& posed) {
    requireFinite(posed.corners.normals, posed);
    for (const auto& set : posed.corners.texCoords) requireFinite(set, posed);
    requireFinite(posed.corners.colours, posed);
    for (const vec3& n : posed.corners.normals)
        require(n == vec3(0.0f) || std::fabs(glm::length(n) - 1.0f) < 1e-5f, "a normal has a direction, or is zero");
}

void requireSound(const Scene& scene, const PosedScene& posed) {
    require(posed.triangles.size() <= kMostTriangles, "the limit holds");
    require(posed.triangles.size() == posed.materialOf.size(), "each triangle has a material");
    for (const uint32_t material : posed.materialOf) require(material < scene.materials.size(), "a material exists");
    require(!scene.materials.empty(), "there is a default material");
    for (const gltf::Material& material : scene.materials)
        for (int i = 0; i < 4; ++i)
            require(material.baseColour[i] >= 0.0f && material.baseColour[i] <= 1.0f, "colours are in [0, 1]");
    requireSoundCorners(posed);
    for (const Camera& camera : posed.cameras)
        require(isUnit(camera.forward) && isUnit(camera.up) && std::fabs(glm::dot(camera.forward, camera.up)) < 1e-6,
                "a camera has directions", camera.name);
    for (const PlacedLight& light : posed.lights)
        require(light.light < scene.lights.size() && isUnit(light.direction), "a light exists, and has a direction");
    for (const auto& warnings : {scene.warnings, posed.warnings})
        for (const std::string& warning : warnings) requireOneLine(warning);
}

// At rest and at times before, between and after most keys.
void poseAtTimes(const Scene& scene) {
    const std::vector<uint32_t> all = allAnimations(scene);
    for (const std::optional<double> seconds : {std::optional<double>(), {-1.0}, {0.0}, {0.37}, {1e9}})
        requireSound(scene, pose(scene, {seconds, all}, kMostTriangles, Detail::corners));
}

}  // namespace
}  // namespace cleave::fuzz

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    const TimeLimit limit;
    static const SceneFolder folder;
    static const Watch outside(folder.outside());
    try {
        poseAtTimes(cleave::loadGltf(folder.folder() / "scene.gltf", {data, size}, kMostTriangles));
    } catch (const cleave::Error& error) {
        requireOneLine(error.what());
    }
    require(!outside.sawOpening(), "no URI leaves the scene's folder");
    return 0;
}
