#include "peers/triangle_order.h"

#include <algorithm>

namespace cleave {
namespace {

constexpr uint32_t kSteps = 1024;  // per axis

// Moves the ten low bits apart, so that two others fit between each two.
uint32_t spread(uint32_t bits) {
    bits = (bits | bits << 16) & 0x030000FFu;
    bits = (bits | bits << 8) & 0x0300F00Fu;
    bits = (bits | bits << 4) & 0x030C30C3u;
    return (bits | bits << 2) & 0x09249249u;
}

}  // namespace

uint32_t mortonCode(const vec3& point, const Box& box) {
    uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = double{box.hi[axis]} - double{box.lo[axis]};
        if (!(extent > 0.0)) continue;
        const double along = (double{point[axis]} - double{box.lo[axis]}) / extent * kSteps;
        code |= spread(static_cast<uint32_t>(std::clamp(along, 0.0, kSteps - 1.0))) << axis;
    }
    return code;
}

std::vector<uint32_t> numbersInOrder(const TriangleSet& set, TriangleOrder order) {
    if (order == TriangleOrder::file) return set.included;
    std::vector<std::pair<uint32_t, uint32_t>> coded;  // ties by number
    coded.reserve(set.included.size());
    for (const uint32_t number : set.included) {
        const Triangle& t = set.triangles[number];
        coded.emplace_back(mortonCode((t.a + t.b + t.c) / 3.0f, set.bounds), number);
    }
    std::sort(coded.begin(), coded.end());
    std::vector<uint32_t> numbers;
    numbers.reserve(coded.size());
    for (const auto& [code, number] : coded) numbers.push_back(number);
    return numbers;
}

}  // namespace cleave
