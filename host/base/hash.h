// A hash of words, by which trees and hits are compared between builders, runs and versions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace cleave {

// FNV-1a over 32-bit words, finished by the mixer of MurmurHash3.
class Hash {
  public:
    void add(uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) state_ = (state_ ^ (word >> shift & 0xFFu)) * 0x100000001B3u;
    }

    uint64_t value() const {
        uint64_t h = state_;
        h = (h ^ h >> 33) * 0xFF51AFD7ED558CCDu;
        h = (h ^ h >> 33) * 0xC4CEB9FE1A85EC53u;
        return h ^ h >> 33;
    }

    // 16 hexadecimal digits.
    std::string text() const {
        std::string digits(16, '0');
        for (size_t i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[value() >> (60 - 4 * i) & 15u];
        return digits;
    }

  private:
    uint64_t state_ = 0xCBF29CE484222325u;
};

}  // namespace cleave
