#include "app/timing.h"

#include <algorithm>

namespace cleave {

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::optional<double> mraysPerSecond(uint64_t rays, double ms) {
    if (!(ms > 0.0) || rays == 0) return std::nullopt;
    return static_cast<double>(rays) / (1000.0 * ms);
}

}  // namespace cleave
