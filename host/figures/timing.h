// Figures derived from times, and the peak memory of the process.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace cleave {

// The middle value, or the mean of the two middle ones. `values` is not empty.
double medianOf(std::vector<double> values);

// What several runs took, ms.
struct Spread {
    double median = 0.0, low = 0.0, high = 0.0;
    uint32_t runs = 0;
};
// Of at least one run.
Spread spreadOf(const std::vector<double>& runs);

// Millions of rays per second; nothing where no time was measured.
std::optional<double> mraysPerSecond(uint64_t rays, double ms);

// Nothing where one is missing or there is nothing to divide by.
std::optional<double> ratio(std::optional<double> value, std::optional<double> to);

// Bytes of memory that this process has had at most: programs, libraries and, on CPU devices, device memory included.
uint64_t processPeakBytes();

}  // namespace cleave
