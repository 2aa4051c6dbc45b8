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
        const PictureArrays device = pair.onDevice(PictureKernels::camera_rays);
        pair.onTwin(PictureKernels::camera_rays);
        for (size_t i = 0; i < device.rays.size(); i++)
            ASSERT_EQ(std::memcmp(&device.rays[i], &pair.arrays.rays[i], sizeof(Ray)), 0) << "ray " << i;
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
