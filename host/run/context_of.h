// The recording library's context on a device of ours.
#pragma once

#include <memory>
#include <span>

#include "cleave/cleave.hpp"
#include "gpu/device.h"

namespace cleave {

// What a context has beside its modes and searches: nothing, the kernels of builds, or those of expansions, too.
enum class Building { none, trees, openTrees };

// Throws Error.
std::unique_ptr<Context> contextOf(const Device& device, std::span<const TraceMode> modes, Building building,
                                   uint32_t groupLanes = 0, std::span<const Search> searches = {});

}  // namespace cleave
