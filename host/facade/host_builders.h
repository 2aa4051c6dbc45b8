// All builders that run on the CPU, by name.
#pragma once

#include <span>
#include <string_view>

#include "tree/tree_builder.h"

namespace cleave {

// The device's twin, then cpuBuilders().
std::span<const TreeBuilder> hostBuilders();

// Throws Error if no builder on the CPU has the name.
const TreeBuilder& hostBuilder(std::string_view name);

}  // namespace cleave
