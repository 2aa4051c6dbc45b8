// Makes the tables that shaders/shared/emitter.h draws from.
#pragma once

#include <span>
#include <vector>

#include "shared/emitter.h"

namespace cleave {

// A slot for each item; `items[i]` is drawn as often as its weight's share of all says, to within the rounding of a
// float. Weights are above 0 and finite, and so is their sum.
std::vector<AliasSlot> aliasTable(std::span<const double> weights, std::span<const uint32_t> items);

}  // namespace cleave
