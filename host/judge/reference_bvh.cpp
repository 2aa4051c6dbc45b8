#include "judge/reference_bvh.h"

namespace cleave {

ReferenceBvh::ReferenceBvh(std::span<const Triangle> world, std::span<const uint32_t> included)
    : order_(included.begin(), included.end()) {
    if (order_.empty()) return;
    nodes_.resize(1);
    build(0, world, 0, static_cast<uint32_t>(order_.size()));
}

// Splits by number of triangles into halves, so that the depth is at most its log2 and `traverse` has stack enough.
void ReferenceBvh::build(uint32_t index, std::span<const Triangle> world, uint32_t begin, uint32_t end) {
    constexpr uint32_t kLeafSize = 4;
    Box box = emptyBox(), firsts = emptyBox();
    for (uint32_t i = begin; i < end; ++i) {
        const Triangle& t = world[order_[i]];
        firsts = including(firsts, t.a);
        box = including(including(including(box, t.a), t.b), t.c);
    }
    if (end - begin <= kLeafSize) {
        nodes_[index] = {box, begin, end - begin, 0};
        return;
    }
    // In double: the extent of a scene near the largest float is beyond float.
    const dvec3 extent = dvec3(firsts.hi) - dvec3(firsts.lo);
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](uint32_t a, uint32_t b) { return world[a].a[axis] < world[b].a[axis]; });
    const auto child = static_cast<uint32_t>(nodes_.size());
    nodes_[index] = {box, child, 0, static_cast<uint32_t>(axis)};
    nodes_.resize(nodes_.size() + 2);
    build(child, world, begin, middle);
    build(child + 1, world, middle, end);
}

}  // namespace cleave
