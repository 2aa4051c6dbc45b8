#include "run/ranges.h"

#include <algorithm>

namespace cleave {

void RangeBuffers::reserve(Device& device, std::span<const VkDeviceSize> sizes) {
    const bool fits = std::equal(buffers_.begin(), buffers_.end(), sizes.begin(), sizes.end(),
                                 [](const Buffer& had, VkDeviceSize wanted) { return had.size() == wanted; });
    if (fits) return;
    clear();  // what there was is freed first
    for (const VkDeviceSize size : sizes) {
        buffers_.emplace_back(device, size);
        ranges_.push_back(rangeOf(buffers_.back()));
    }
}

void RangeBuffers::clear() {
    buffers_.clear();
    ranges_.clear();
}

uint64_t RangeBuffers::bytes() const {
    uint64_t sum = 0;
    for (const Buffer& b : buffers_) sum += b.size();
    return sum;
}

}  // namespace cleave
