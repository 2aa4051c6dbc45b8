// The order in which peers are given the triangles. Some builders keep to it, so it decides how good their trees are.
#pragma once

#include <cstdint>
#include <vector>

#include "tree/triangle_set.h"

namespace cleave {

enum class TriangleOrder {
    file,    // by number
    morton,  // along a space-filling curve: neighbours in the list are neighbours in space
};

// The included triangles' numbers in that order.
std::vector<uint32_t> numbersInOrder(const TriangleSet& set, TriangleOrder order);

// Interleaves the bits of a point's place in the box, 10 bits per axis.
uint32_t mortonCode(const vec3& point, const Box& box);

}  // namespace cleave
