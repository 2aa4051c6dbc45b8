// Places arrays in ranges of memory: in one, unless a range may not be larger than the device allows.
#pragma once

#include <cstdint>

namespace cleave {

// Where an array begins: which range, and bytes from its start.
struct Place {
    uint32_t range = 0;
    uint64_t offset = 0;
};

class Placement {
  public:
    static constexpr uint32_t kMostRanges = 16;
    static constexpr uint64_t kAlignment = 64;

    // `largest`: bytes that a range may have; 0: any.
    explicit Placement(uint64_t largest) : largest_(largest == 0 ? UINT64_MAX : largest) {}

    Place place(uint64_t bytes) {
        const uint64_t padded = (bytes + kAlignment - 1) / kAlignment * kAlignment;
        if (sizes_[count_ - 1] > 0 && sizes_[count_ - 1] + padded > largest_) {
            fits_ = fits_ && count_ < kMostRanges;
            if (fits_) count_++;
        }
        fits_ = fits_ && padded <= largest_;
        const Place at{count_ - 1, sizes_[count_ - 1]};
        sizes_[count_ - 1] += padded;
        return at;
    }

    uint32_t rangeCount() const { return count_; }
    uint64_t size(uint32_t range) const { return sizes_[range]; }
    // False: an array is larger than a range may be, or there are too many ranges.
    bool fits() const { return fits_; }

  private:
    uint64_t largest_;
    uint64_t sizes_[kMostRanges] = {};
    uint32_t count_ = 1;
    bool fits_ = true;
};

}  // namespace cleave
