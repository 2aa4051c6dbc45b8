// Numbers from a seed, the same with every compiler and library.
#pragma once

#include <cstdint>
#include <string_view>

#include "shared/box.h"

namespace cleave {

// SplitMix64 (Steele, Lea and Flood 2014): one addition and one mix per number, so that a generator per case, per ray
// family and per batch of rays costs nothing.
class Random {
  public:
    explicit Random(uint64_t seed) : state_(seed) {}

    uint64_t bits() {
        uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
        z = (z ^ z >> 27) * 0x94D049BB133111EBu;
        return z ^ z >> 31;
    }
    uint32_t below(uint64_t n) { return static_cast<uint32_t>(bits() % n); }  // n is not 0
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }     // in [0, 1)
    double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
    double sign() { return bits() % 2 == 0 ? 1.0 : -1.0; }
    dvec3 inBox(const dvec3& lo, const dvec3& hi) {
        const double x = between(lo.x, hi.x), y = between(lo.y, hi.y);
        return {x, y, between(lo.z, hi.z)};
    }
    // Not of unit length and not evenly spread over the sphere, which nothing here needs.
    dvec3 direction() { return inBox(dvec3(-1.0), dvec3(1.0)); }

  private:
    uint64_t state_;
};

// The seed of a part of a run: of a case, of a ray family.
inline uint64_t seedFor(uint64_t seed, std::string_view part) {
    for (const char c : part) seed = Random(seed ^ static_cast<unsigned char>(c)).bits();
    return seed;
}

}  // namespace cleave
