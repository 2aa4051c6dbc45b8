// Buffers for what is recorded into ranges of memory.
#pragma once

#include <vector>

#include "cleave/cleave.hpp"
#include "gpu/buffer.h"

namespace cleave {

inline Range rangeOf(const Buffer& buffer) { return {buffer.handle(), 0, buffer.size(), buffer.address()}; }

// One buffer per range; kept from use to use while the sizes stay.
class RangeBuffers {
  public:
    void reserve(Device& device, std::span<const VkDeviceSize> sizes);
    void clear();

    const Range* ranges() const { return ranges_.data(); }
    const Buffer& buffer(uint32_t range) const { return buffers_[range]; }
    uint64_t bytes() const;

  private:
    std::vector<Buffer> buffers_;
    std::vector<Range> ranges_;
};

}  // namespace cleave
