#include "figures/timing.h"

#include <sys/resource.h>

#include <algorithm>

namespace cleave {

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Spread spreadOf(const std::vector<double>& runs) {
    const auto [low, high] = std::minmax_element(runs.begin(), runs.end());
    return {medianOf(runs), *low, *high, static_cast<uint32_t>(runs.size())};
}

std::optional<double> mraysPerSecond(uint64_t rays, double ms) {
    if (!(ms > 0.0) || rays == 0) return std::nullopt;
    return static_cast<double>(rays) / (1000.0 * ms);
}

std::optional<double> ratio(std::optional<double> value, std::optional<double> to) {
    if (!value || !to || *to == 0.0) return std::nullopt;
    return *value / *to;
}

uint64_t processPeakBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace cleave
