// Small random scenes where coincidences are common, and rays that seek them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shared/ray.h"
#include "shared/triangle.h"
#include "tree/kd_tree.h"

namespace cleave::test {

// 1 to 60 triangles in world space on a grid of a few steps (shared vertices, edges and planes; duplicates; flat and
// degenerate ones), moved and scaled as a whole; rays on the same grid; settings that shape other trees. In three of
// four scenes all arithmetic on coordinates is exact. In the others they are rounded thirds, or vertices are off the
// grid by an ulp: near coincidences.
struct QueryCase {
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;  // a few of them invalid
    BuildSettings settings;
};

// The same numbers give the same case on every machine.
QueryCase queryCase(uint32_t seed, uint64_t scene, size_t rayCount);

// As C++ initialisers, without loss.
std::string codeOf(const Triangle& triangle);
std::string codeOf(const Ray& ray);

}  // namespace cleave::test
