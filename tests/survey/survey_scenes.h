// Scenes of the tests of the survey's claims.
#pragma once

#include <cmath>

#include "support/small_scenes.h"

namespace cleave::test {

// A sheet of n x n squares, 2 n^2 triangles, turned and slightly bent so that no plane runs along its rows.
inline std::vector<Triangle> turnedGrid(uint32_t n) {
    const auto at = [&](uint32_t i, uint32_t j) {
        const float u = static_cast<float>(i) / static_cast<float>(n) - 0.5f,
                    v = static_cast<float>(j) / static_cast<float>(n) - 0.5f;
        return vec3(0.8f * u - 0.6f * v, 0.6f * u + 0.8f * v, 0.1f * u * v + 0.03f * u);
    };
    return sheetOf(n, at);
}

}  // namespace cleave::test
