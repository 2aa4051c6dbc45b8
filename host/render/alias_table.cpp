#include "render/alias_table.h"

#include <numeric>

namespace cleave {

// Each slot is as high as the mean. An item that is lower has one of its own, and one that is higher fills it up; what
// is left of the latter is then lower or higher itself (Vose 1991, "A linear algorithm for generating random numbers
// with a given distribution").
std::vector<AliasSlot> aliasTable(std::span<const double> weights, std::span<const uint32_t> items) {
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
    std::vector<double> left;
    std::vector<size_t> lower, higher;
    for (size_t i = 0; i < weights.size(); ++i) {
        left.push_back(weights[i] / mean);
        (left[i] < 1.0 ? lower : higher).push_back(i);
    }
    std::vector<AliasSlot> slots;
    for (const uint32_t item : items) slots.push_back({item, item, 1.0f});
    while (!lower.empty() && !higher.empty()) {
        const size_t low = lower.back(), high = higher.back();
        lower.pop_back();
        slots[low].chance = static_cast<float>(left[low]);
        slots[low].second = items[high];
        left[high] -= 1.0 - left[low];
        if (left[high] >= 1.0) continue;
        higher.pop_back();
        lower.push_back(high);
    }
    return slots;
}

}  // namespace cleave
