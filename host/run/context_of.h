// The recording library's context on a device of ours.
#pragma once

#include <memory>
#include <span>

#include "cleave/cleave.hpp"
#include "gpu/device.h"

namespace cleave {

// Throws Error.
std::unique_ptr<Context> contextOf(const Device& device, std::span<const TraceMode> modes, bool builds,
                                   uint32_t groupLanes = 0, std::span<const Search> searches = {},
                                   bool exactBuilds = false);

}  // namespace cleave
