// Ascending order of 32-bit keys.
#pragma once

#include <cstdint>
#include <vector>

namespace cleave {

// `scratch` is overwritten; the caller keeps it to spare allocations.
void sortKeys(std::vector<uint32_t>& keys, std::vector<uint32_t>& scratch);

}  // namespace cleave
