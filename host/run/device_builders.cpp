#include "run/device_builders.h"

#include <algorithm>

namespace cleave {
namespace {

constexpr DeviceBuilder kDeviceBuilders[] = {
    {"gpu", false, "min-max binning on the device (Shevtsov et al. 2007), the default"},
    {"gpu-exact", true, "exact SAH on the device: the tree of exact"},
};

}  // namespace

std::span<const DeviceBuilder> deviceBuilders() { return kDeviceBuilders; }

bool isOnDevice(std::string_view name) {
    return std::ranges::find(kDeviceBuilders, name, &DeviceBuilder::name) != std::end(kDeviceBuilders);
}

BuildSettings settingsFor(std::string_view name, BuildSettings settings) {
    const auto* const builder = std::ranges::find(kDeviceBuilders, name, &DeviceBuilder::name);
    settings.exact = builder != std::end(kDeviceBuilders) && builder->exact;
    return settings;
}

}  // namespace cleave
