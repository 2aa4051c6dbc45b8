#include <gtest/gtest.h>

#include "support/picture.h"
#include "twin/render.h"

namespace cleave::test {

TEST(ShadowRays, EqualTwinAtEverySize) {
    for (uint32_t n : kSizes) {
        SCOPED_TRACE("pixels " + std::to_string(n));
        PictureInput in(n, n + 1);
        const std::vector<Ray> device = in.shadowRaysOnDevice();
        const std::vector<Ray> twin = twin::shadowRays(in.arrays(), in.offset);
        ASSERT_EQ(device.size(), twin.size());
        for (size_t i = 0; i < n; i++) {
            // Square roots and quotients may differ by rounding between devices.
            for (int k = 0; k < 3; k++) {
                ASSERT_NEAR(device[i].origin[k], twin[i].origin[k], 1e-6f) << "pixel " << i;
                ASSERT_EQ(device[i].direction[k], twin[i].direction[k]) << "pixel " << i;
            }
            ASSERT_EQ(device[i].tMin, twin[i].tMin) << "pixel " << i;
            ASSERT_EQ(device[i].tMax, twin[i].tMax) << "pixel " << i;
        }
    }
}

// A floor seen from above: the ray starts above it, towards the sun; where nothing was hit it has no length.
TEST(ShadowRays, StartOnTheSideThatIsSeen) {
    const Triangle floor{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const Ray down{{0.2f, 1, 0.2f}, 0, {0, -1, 0}, 10};
    const Ray up{{0.2f, -1, 0.2f}, 0, {0, 1, 0}, 10};
    EXPECT_FLOAT_EQ(shadowRay(down, Hit{1, 0, 0, 0}, floor, 0.25f).origin.y, 0.25f);
    EXPECT_FLOAT_EQ(shadowRay(up, Hit{1, 0, 0, 0}, floor, 0.25f).origin.y, -0.25f);
    EXPECT_EQ(shadowRay(down, Hit{1, 0, 0, 0}, floor, 0.25f).direction, towardsSun());
    EXPECT_EQ(shadowRay(down, missedHit(), floor, 0.25f).tMax, 0.0f);
    EXPECT_NEAR(glm::length(towardsSun()), 1.0f, 1e-6f);
}

}  // namespace cleave::test
