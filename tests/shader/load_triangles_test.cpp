#include <gtest/gtest.h>

#include <cstring>

#include "support/build_pass.h"
#include "support/scenes.h"

namespace cleave::test {

TEST(LoadTriangles, EqualsTwinAtEverySize) {
    uint32_t seed = 1;
    for (uint32_t n : kSizes) expectPassEqualsTwin("load_triangles", n, seed++);
}

// The device loads the same triangles that the host's builders are given.
TEST(LoadTriangles, MakesTheTriangleSetOfTheHost) {
    std::vector<Triangle> world = mixedTriangles(1000, 9);
    world[3].a.x = NAN;
    world[5].b = world[5].a;
    world[700].c.y = 1e6f;
    const TriangleSet set = makeTriangleSet(world);
    BuildArrays a = makeArrays(world, {}, {});
    twin::findScale(a, 0);
    twin::loadTriangles(a, 0);
    EXPECT_EQ(sceneExponent(a.state.scene.largest), set.exponent);
    EXPECT_EQ(a.state.scene.nonFinite, set.nonFinite);
    EXPECT_EQ(a.state.scene.noArea, set.noArea);
    a.state.scene.included = static_cast<uint32_t>(set.included.size());
    EXPECT_EQ(rootCell(a.state.scene).lo, set.bounds.lo);
    EXPECT_EQ(rootCell(a.state.scene).hi, set.bounds.hi);
    for (uint32_t i = 0; i < world.size(); i++) {
        EXPECT_EQ(std::memcmp(&a.triangles[i], &set.triangles[i], sizeof(Triangle)), 0) << i;
        EXPECT_EQ(a.triangles[i].number, i);
    }
}

}  // namespace cleave::test
