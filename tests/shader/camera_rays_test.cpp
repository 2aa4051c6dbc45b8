#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "support/picture.h"

namespace cleave::test {

TEST(CameraRays, EqualTwinAtEverySize) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height));
        PicturePair pair(size.width, size.height, View::normals, seed++);
        pair.arrays.samples = 1 + seed % 2;
        const PassNumbers numbers{0, seed % 3};
        const PictureArrays device = pair.onDevice(PictureKernels::camera_rays, numbers);
        pair.onTwin(PictureKernels::camera_rays, numbers);
        for (size_t i = 0; i < device.rays.size(); i++)
            ASSERT_EQ(std::memcmp(&device.rays[i], &pair.arrays.rays[i], sizeof(Ray)), 0) << "ray " << i;
    }
}

// A single sample is at the centre; several are all over the pixel, about its centre on the average.
TEST(CameraRays, SamplesFillTheirPixel) {
    EXPECT_EQ(placeInPixel(1, 7, 3, 0), vec2(0.5f));
    glm::dvec2 sum(0.0);
    vec2 low(1.0f), high(0.0f);
    constexpr uint32_t kSamples = 4096;
    for (uint32_t path = 0; path < kSamples; path++) {
        const vec2 place = placeInPixel(kSamples, 7, 3, path);
        sum += glm::dvec2(place);
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    EXPECT_NEAR(sum.x / kSamples, 0.5, 4.0 * 0.2887 / 64.0);
    EXPECT_NEAR(sum.y / kSamples, 0.5, 4.0 * 0.2887 / 64.0);
    for (int k = 0; k < 2; k++) {
        EXPECT_GE(low[k], 0.0f);
        EXPECT_LT(low[k], 0.01f);
        EXPECT_LT(high[k], 1.0f);
        EXPECT_GT(high[k], 0.99f);
    }
}

// Every pixel has one ray, and lanes that are neighbours look at a compact patch.
TEST(CameraRays, CoverThePictureOnceInPatches) {
    for (const PictureSize& size : kPictureSizes) {
        std::set<uint32_t> seen;
        const uint32_t count = size.width * size.height;
        for (uint32_t i = 0; i < count; i++) seen.insert(pixelOf(i, size.width, size.height));
        EXPECT_EQ(seen.size(), count);
        EXPECT_LT(*seen.rbegin(), count);
    }
    for (uint32_t lanes : {4u, 8u, 16u, 32u, 64u})
        for (uint32_t first = 0; first < 64 * 6; first += lanes) {
            uint32_t loX = ~0u, loY = ~0u, hiX = 0, hiY = 0;
            for (uint32_t i = first; i < first + lanes; i++) {
                const uint32_t pixel = pixelOf(i, 24, 16), x = pixel % 24, y = pixel / 24;
                loX = std::min(loX, x), hiX = std::max(hiX, x), loY = std::min(loY, y), hiY = std::max(hiY, y);
            }
            EXPECT_EQ((hiX - loX + 1) * (hiY - loY + 1), lanes) << "from ray " << first;
            EXPECT_LE(hiX - loX + 1, 2 * (hiY - loY + 1));
        }
}

}  // namespace cleave::test
