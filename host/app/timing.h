// What a run took, and what is made of it.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace cleave {

class Stopwatch {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The middle value, or the mean of the two middle ones. `values` is not empty.
double medianOf(std::vector<double> values);

// Millions of rays per second; nothing where no time was measured.
std::optional<double> mraysPerSecond(uint64_t rays, double ms);

// Bytes of memory that this process has had at most: programs, libraries and, on CPU devices, device memory included.
uint64_t processPeakBytes();

}  // namespace cleave
