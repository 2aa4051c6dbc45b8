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

// A floor seen from above: the ray starts above it, towards the sun; where nothing was hit there is none.
TEST(ShadowRays, StartOnTheSideThatIsSeen) {
    const Triangle floor{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const Ray down{{0.2f, 1, 0.2f}, 0, {0, -1, 0}, 10};
    const Ray up{{0.2f, -1, 0.2f}, 0, {0, 1, 0}, 10};
    const Hit hit{1, 0, 0.2f, 0.2f};
    EXPECT_GT(shadowRay(down, hit, floor).origin.y, 0.0f);
    EXPECT_LT(shadowRay(up, hit, floor).origin.y, 0.0f);
    EXPECT_LT(shadowRay(down, hit, floor).origin.y, 1e-6f);
    EXPECT_EQ(shadowRay(down, hit, floor).direction, towardsSun());
    EXPECT_TRUE(isNoRay(shadowRay(down, missedHit(), floor)));
    EXPECT_NEAR(glm::length(towardsSun()), 1.0f, 1e-6f);
}

}  // namespace cleave::test
