#include "scene/sides.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace cleave::test {
namespace {

// A tetrahedron whose triangles go counterclockwise seen from outside.
std::vector<Triangle> solid(float scale) {
    const vec3 o = vec3(5, 6, 7) * scale, x = o + vec3(scale, 0, 0), y = o + vec3(0, scale, 0),
               z = o + vec3(0, 0, scale);
    return {{o, y, x}, {o, z, y}, {o, x, z}, {x, y, z}};
}

std::vector<Triangle> turned(std::vector<Triangle> triangles) {
    for (Triangle& t : triangles) std::swap(t.b, t.c);
    return triangles;
}

TEST(Sides, WhatIsTurnedInHasNoBack) {
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        EXPECT_EQ(sidesOf(solid(scale), false), 0u);
        EXPECT_EQ(sidesOf(turned(solid(scale)), false), kNoBack);
        EXPECT_EQ(sidesOf(turned(solid(scale)), true), kMirrored) << "the node has turned it in";
        EXPECT_EQ(sidesOf(solid(scale), true), kMirrored | kNoBack);
    }
}

TEST(Sides, WhatEnclosesNothingKeepsItsBack) {
    const std::vector<Triangle> plane{{{3, 1, 2}, {4, 1, 2.5f}, {3, 2, 2}}, {{4, 2, 2.5f}, {3, 2, 2}, {4, 1, 2.5f}}};
    EXPECT_EQ(sidesOf(plane, false), 0u);
    EXPECT_EQ(sidesOf(turned(plane), false), 0u);
    EXPECT_EQ(sidesOf({}, false), 0u);
    const std::vector<Triangle> point(2, {vec3(1), vec3(1), vec3(1)});
    EXPECT_EQ(sidesOf(point, false), 0u);
    std::vector<Triangle> broken = turned(solid(1));
    broken[0].a.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(sidesOf(broken, false), 0u);
}

}  // namespace
}  // namespace cleave::test
