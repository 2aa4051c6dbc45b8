// The input of every builder: the triangles scaled to about unit size, without those that no tree can be built over.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/box.h"
#include "shared/triangle.h"

namespace cleave {

struct TriangleSet {
    std::vector<Triangle> triangles;  // all of the scene's, times 2^-exponent; those left out are zeroed
    std::vector<uint32_t> included;   // ascending numbers of the triangles that a tree is built over
    Box bounds = emptyBox();          // of the included ones; empty without any
    int exponent = 0;                 // world = scaled * 2^exponent; largest scaled |coordinate| is in [0.5, 1)
    uint64_t nonFinite = 0;           // left out: a vertex is NaN or infinite
    uint64_t noArea = 0;              // left out: the three vertices lie on a line
};

// Scales, and leaves out what is not finite or has exactly no area. A triangle that is left out keeps its number.
TriangleSet makeTriangleSet(std::span<const Triangle> world, std::span<const uint32_t> list = {});

// Those of the triangles, in their order, as a scene of their own.
std::vector<Triangle> trianglesOf(std::span<const Triangle> world, std::span<const uint32_t> list);

}  // namespace cleave
