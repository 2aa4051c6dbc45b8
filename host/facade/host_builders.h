// All builders by name, and those that run on the CPU.
#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "tree/tree_builder.h"

namespace cleave {

// The device's twin, then cpuBuilders().
std::span<const TreeBuilder> hostBuilders();

// Names and descriptions of all: those that run on the device, then these.
std::span<const std::pair<std::string_view, std::string_view>> allBuilders();

// Throws Error if no builder on the CPU has the name.
const TreeBuilder& hostBuilder(std::string_view name);

}  // namespace cleave
