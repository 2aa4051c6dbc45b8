#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

TEST(ShadowRays, EqualTwinAtEverySize) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height));
        PicturePair pair(size.width, size.height, View::shaded, seed++);
        const std::vector<Ray> device = pair.onDevice(PictureKernels::shadow_rays).shadowRays;
        pair.onTwin(PictureKernels::shadow_rays);
        const std::vector<Ray>& twin = pair.arrays.shadowRays;
        for (size_t i = 0; i < device.size(); i++) {
            // Square roots and quotients may differ by rounding between devices.
            for (int k = 0; k < 3; k++) {
                ASSERT_NEAR(device[i].origin[k], twin[i].origin[k], 1e-5f) << "pixel " << i;
                ASSERT_EQ(device[i].direction[k], twin[i].direction[k]) << "pixel " << i;
            }
            ASSERT_EQ(device[i].tMin, twin[i].tMin) << "pixel " << i;
            ASSERT_EQ(device[i].tMax, twin[i].tMax) << "pixel " << i;
        }
    }
}

// A box of 3 x 4 x 12 scaled by 2^-4 has a diagonal of 13 in the world.
TEST(ShadowRays, StartTenThousandthsOfTheDiagonalOff) {
    const Box box{{0, 0, 0}, {3.0f / 16, 4.0f / 16, 12.0f / 16}};
    EXPECT_EQ(shadowOffset(box, 4), 1e-4f * 13.0f);
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
