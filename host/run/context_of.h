// The recording library's context on a device of ours.
#pragma once

#include <memory>
#include <span>

#include "cleave/cleave.hpp"
#include "gpu/device.h"

namespace cleave {

// The kernels that a context has beside those of its modes and searches.
struct Building {
    bool trees = false;
    bool exact = false;  // of builds with BuildSettings::exact, too
    bool open = false;   // of expansions, too
};

// Throws Error.
std::unique_ptr<Context> contextOf(const Device& device, std::span<const TraceMode> modes, Building building,
                                   uint32_t groupLanes = 0, std::span<const Search> searches = {});

}  // namespace cleave
