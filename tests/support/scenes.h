// Triangles for tests, made from seeds.
#pragma once

#include <cstdint>
#include <random>

#include "tree/triangle_set.h"

namespace cleave::test {

// n triangles in the unit cube, of all sizes; some flat in an axis, some on a grid, so that faces coincide.
inline std::vector<Triangle> mixedTriangles(uint32_t n, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<Triangle> triangles;
    const float typical = 1.5f / std::cbrt(static_cast<float>(n) + 1.0f);
    for (uint32_t i = 0; i < n; i++) {
        const float size = typical * (i % 17 == 0 ? 5.0f : 1.0f);
        glm::vec3 v[3];
        const glm::vec3 centre(unit(random), unit(random), unit(random));
        for (glm::vec3& p : v)
            for (int k = 0; k < 3; k++) p[k] = centre[k] + size * (unit(random) - 0.5f);
        if (i % 5 == 0)
            for (glm::vec3& p : v) p[static_cast<int>(i / 5 % 3)] = std::round(centre.x * 8.0f) / 8.0f;
        if (i % 7 == 0)
            for (glm::vec3& p : v) p = glm::round(p * 16.0f) / 16.0f;
        triangles.push_back({v[0], v[1], v[2]});
    }
    return triangles;
}

inline TriangleSet mixedSet(uint32_t n, uint32_t seed) { return makeTriangleSet(mixedTriangles(n, seed)); }

// Below, at and above a workgroup, a block, a chunk, and their squares.
constexpr uint32_t kSizes[] = {0,          1,          2,      kExactUpTo, kExactUpTo + 1, kGroup - 1,         kGroup,
                               kGroup + 1, kBlock - 1, kBlock, kBlock + 1, 2 * kGroup + 1, kGroup* kGroup + 1, 65537};

}  // namespace cleave::test
