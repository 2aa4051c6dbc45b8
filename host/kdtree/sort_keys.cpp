#include "kdtree/sort_keys.h"

#include <algorithm>
#include <array>

namespace cleave {

// Three counting passes of 11 bits, from the lowest; comparison sort where clearing the tables would cost more.
void sortKeys(std::vector<uint32_t>& keys, std::vector<uint32_t>& scratch) {
    constexpr size_t kFewKeys = 1500;
    constexpr uint32_t kBits = 11, kDigits = 1u << kBits;
    if (keys.size() < kFewKeys) {
        std::sort(keys.begin(), keys.end());
        return;
    }
    scratch.resize(keys.size());
    for (uint32_t shift = 0; shift < 32; shift += kBits) {
        std::array<uint32_t, kDigits> next{};
        for (const uint32_t key : keys) ++next[key >> shift & (kDigits - 1)];
        uint32_t sum = 0;
        for (uint32_t& n : next) {
            const uint32_t count = n;
            n = sum;
            sum += count;
        }
        for (const uint32_t key : keys) scratch[next[key >> shift & (kDigits - 1)]++] = key;
        keys.swap(scratch);
    }
}

}  // namespace cleave
