#include <gtest/gtest.h>

#include <cmath>

#include "shared/light_rays.h"
#include "support/picture.h"

namespace cleave::test {

// Square roots and quotients may differ by rounding between devices.
TEST(ShadowRays, EqualTwinAtEverySize) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes)
        for (const uint32_t samples : {1u, 5u}) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", " +
                         std::to_string(samples) + " samples");
            PicturePair pair(size.width, size.height, View::shaded, seed++, samples);
            const std::vector<Ray> device = pair.onDevice(PictureKernels::shadow_rays, {0, 3}).shadowRays;
            pair.onTwin(PictureKernels::shadow_rays, {0, 3});
            const std::vector<Ray>& twin = pair.arrays.shadowRays;
            ASSERT_EQ(device.size(), size_t{size.width} * size.height * (samples > 1 ? 2 : 1));
            for (size_t i = 0; i < device.size(); i++) {
                for (int k = 0; k < 3; k++) {
                    ASSERT_NEAR(device[i].origin[k], twin[i].origin[k], 1e-5f) << "ray " << i;
                    ASSERT_NEAR(device[i].direction[k], twin[i].direction[k], samples > 1 ? 1e-5f : 0.0f)
                        << "ray " << i;
                }
                ASSERT_EQ(device[i].tMin, twin[i].tMin) << "ray " << i;
                ASSERT_EQ(device[i].tMax, twin[i].tMax) << "ray " << i;
            }
        }
}

const Triangle kFloor{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
const Ray kDown{{0.2f, 1, 0.2f}, 0, {0, -1, 0}, 10};
const Ray kUp{{0.2f, -1, 0.2f}, 0, {0, 1, 0}, 10};
const Hit kOnFloor{1, 0, 0.2f, 0.2f};

LightRays raysFrom(const Ray& ray, uint32_t samples, uint32_t path) {
    return lightRays(ray, kOnFloor, kFloor, kFloor, samples, 2.0f, 7, path);
}

// A floor seen from above: the ray starts above it, towards the sun.
TEST(ShadowRays, StartOnTheSideThatIsSeen) {
    EXPECT_GT(raysFrom(kDown, 1, 0).sun.origin.y, 0.0f);
    EXPECT_LT(raysFrom(kUp, 1, 0).sun.origin.y, 0.0f);
    EXPECT_LT(raysFrom(kDown, 1, 0).sun.origin.y, 1e-6f);
    EXPECT_EQ(raysFrom(kDown, 1, 0).sun.direction, towardsSun());
    EXPECT_TRUE(isNoRay(raysFrom(kDown, 1, 0).around));
    EXPECT_TRUE(isNoRay(noLightRays().sun) && isNoRay(noLightRays().around));
    EXPECT_NEAR(glm::length(towardsSun()), 1.0f, 1e-6f);
    EXPECT_EQ(raysFrom(kUp, 9, 0).around.origin, raysFrom(kUp, 9, 0).sun.origin);
    EXPECT_EQ(raysFrom(kUp, 9, 0).around.tMax, 2.0f);
}

// Each sample has its own point of the sun, and its own direction into the half of the sky above the floor.
TEST(ShadowRays, SamplesSpreadOverTheSunAndTheSky) {
    constexpr uint32_t kSamples = 4096;
    double sine = 0.0, cosine = 0.0;
    for (uint32_t i = 0; i < kSamples; i++) {
        const LightRays rays = raysFrom(kDown, kSamples, i);
        const double off = glm::length(glm::cross(glm::dvec3(rays.sun.direction), glm::dvec3(towardsSun())));
        ASSERT_LE(off, double{kSineOfSun} * 1.0001);
        ASSERT_GE(rays.around.direction.y, 0.0f);
        ASSERT_NEAR(glm::length(rays.around.direction), 1.0f, 1e-6f);
        sine += off / kSamples;
        cosine += double{rays.around.direction.y} / kSamples;
    }
    // The mean distance from the middle of a disc is 2/3; that of the height of cosine-weighted directions, too. Their
    // variances are 1/18.
    const double error = 4.0 * std::sqrt(1.0 / 18.0 / kSamples);
    EXPECT_NEAR(sine / double{kSineOfSun}, 2.0 / 3.0, error);
    EXPECT_NEAR(cosine, 2.0 / 3.0, error);
}

}  // namespace cleave::test
