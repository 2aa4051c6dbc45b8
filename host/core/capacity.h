// How large a build may get: what fits a budget, and what a build that was short of capacity gets next.
#pragma once

#include <optional>

#include "cleave/cleave.hpp"

namespace cleave {

// Bytes of a build with this info: its tree and its scratch memory.
uint64_t buildBytes(const BuildInfo& info) noexcept;

// info.capacity, cut down so that the build takes at most `bytes` (0: no limit), all fields alike; at least one
// reference per triangle, so that the root can be a leaf. Nothing if not even that fits.
std::optional<Capacity> limitedCapacity(const BuildInfo& info, uint64_t bytes) noexcept;

// Gives a build that was short of capacity more of it, where the budget allows: what it wanted and half as much again,
// since a level that did not fit is not the last. No field shrinks. False: info.capacity is as large as it gets.
bool growCapacity(BuildInfo& info, const Capacity& wanted, uint64_t bytes) noexcept;

}  // namespace cleave
