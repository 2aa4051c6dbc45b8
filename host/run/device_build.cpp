#include "run/device_build.h"

#include "tree/build_info.h"

namespace cleave {

BuildInfo deviceBuildInfo(std::span<const Geometry> geometries, const BuildSettings& settings, const Device& device) {
    BuildInfo info = buildInfo(settings);
    info.geometries = geometries.data();
    info.geometryCount = static_cast<uint32_t>(geometries.size());
    info.largestRange = device.largestAllocation();
    return info;
}

BuildSizes requireSizes(const BuildInfo& info) {
    BuildSizes sizes = buildSizes(info);
    if (sizes.failed) throw Error(std::string("cannot build a tree: ") + sizes.failed + "; split the scene");
    return sizes;
}

}  // namespace cleave
