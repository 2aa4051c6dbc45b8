#include <gtest/gtest.h>

#include "support/build_pass.h"
#include "support/scenes.h"

namespace cleave::test {

TEST(FindScale, EqualsTwinAtEverySize) {
    uint32_t seed = 1;
    for (uint32_t n : kSizes) expectPassEqualsTwin("find_scale", n, seed++);
}

// The largest coordinate of a finite vertex counts, also where another vertex of its triangle is not finite.
TEST(FindScale, IsOfFiniteVertices) {
    BuildArrays a = makeArrays(std::vector<Triangle>{{{1, 2, 3}, {0, -5, 0}, {0, 0, 1}},
                                                     {{7, 0, 0}, {NAN, 100, 0}, {0, 0, 0}},
                                                     {{INFINITY, 0, 900}, {0, 0, 0}, {0, 0, 0}}},
                               {}, {});
    twin::findScale(a, 0);
    EXPECT_EQ(uintBitsToFloat(a.state.scene.largest), 7.0f);
    EXPECT_EQ(sceneExponent(a.state.scene.largest), 3);  // 7 / 8 is in [0.5, 1)
    EXPECT_EQ(sceneExponent(0), 0);
}

}  // namespace cleave::test
