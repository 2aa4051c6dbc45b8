// The CPU builders by name: a user chooses one of them, tests and benchmarks go through all.
#pragma once

#include <span>
#include <string_view>

#include "tree/tree_builder.h"

namespace cleave {

// All of them, in the order in which they are listed to a user. The reference of all costs, `exact`, comes first.
std::span<const TreeBuilder> cpuBuilders();

// Throws Error, which lists what there is, if no builder has the name.
const TreeBuilder& cpuBuilder(std::string_view name);

}  // namespace cleave
