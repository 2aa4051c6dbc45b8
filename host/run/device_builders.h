// The builders that run on the device, by name.
#pragma once

#include <span>
#include <string_view>

#include "tree/kd_tree.h"

namespace cleave {

struct DeviceBuilder {
    std::string_view name;
    bool exact;                    // BuildSettings::exact
    std::string_view description;  // half a sentence for a list of builders
};

// All of them, the default first.
std::span<const DeviceBuilder> deviceBuilders();

bool isOnDevice(std::string_view name);

// The settings with what makes it the builder of this name; of builders on the CPU as they are.
BuildSettings settingsFor(std::string_view name, BuildSettings settings);

}  // namespace cleave
