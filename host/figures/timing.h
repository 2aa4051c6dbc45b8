// How times are taken, figures derived from them, and the peak memory of the process.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/stopwatch.h"

namespace cleave {

// A GPU at rest runs at a fraction of its clock, and takes tens of milliseconds of work to raise it: what is shorter
// would be timed at whichever clock there is by chance, and slowest after a while of work on the CPU.
inline constexpr double kWarmUpMs = 100.0;

// Does what is timed next, untimed: once, and again until kWarmUpMs have gone by. Nothing slow may come in between.
template <class Work>
void warmUp(const Work& work) {
    const Stopwatch watch;
    do work();
    while (watch.milliseconds() < kWarmUpMs);
}

// The middle value, or the mean of the two middle ones. `values` is not empty.
double medianOf(std::vector<double> values);

// Millions of rays per second; nothing where no time was measured.
std::optional<double> mraysPerSecond(uint64_t rays, double ms);

// Nothing where one is missing or there is nothing to divide by.
std::optional<double> ratio(std::optional<double> value, std::optional<double> to);

// Bytes of memory that this process has had at most: programs, libraries and, on CPU devices, device memory included.
uint64_t processPeakBytes();

}  // namespace cleave
