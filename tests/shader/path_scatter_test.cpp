#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

namespace {

// Square roots and quotients may differ by rounding between devices; and where a choice hangs on such a bit, a path may
// go another way.
bool isNear(const vec3& a, const vec3& b) {
    for (int k = 0; k < 3; k++)
        if (std::fabs(a[k] - b[k]) > 1e-4f * (1.0f + std::fabs(b[k]))) return false;
    return true;
}

}  // namespace

TEST(PathScatter, EqualsTwinAtEverySizeAndBounce) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        for (const PassNumbers numbers : {PassNumbers{0, 0}, {0, 3}, {1, 0}, {3, 1}, {4, 2}}) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", bounce " +
                         std::to_string(numbers.round) + ", sample " + std::to_string(numbers.path));
            PicturePair pair(size.width, size.height, View::path, seed++);
            const PictureArrays device = pair.onDevice(PictureKernels::path_scatter, numbers);
            pair.onTwin(PictureKernels::path_scatter, numbers);
            const PictureArrays& twin = pair.arrays;
            size_t other = 0;
            for (size_t i = 0; i < device.rays.size(); i++) {
                const bool same = isNear(device.radiance[i], twin.radiance[i]) &&
                                  isNear(vec3(device.unlit[i]), vec3(twin.unlit[i])) &&
                                  device.unlit[i].w == twin.unlit[i].w && isNear(device.direct[i], twin.direct[i]) &&
                                  isNear(device.throughput[i], twin.throughput[i]) &&
                                  isNear(vec3(device.density[i]), vec3(twin.density[i])) &&
                                  isNear(device.rays[i].origin, twin.rays[i].origin) &&
                                  isNear(device.rays[i].direction, twin.rays[i].direction) &&
                                  isNear(device.shadowRays[i].direction, twin.shadowRays[i].direction) &&
                                  device.rays[i].tMax == twin.rays[i].tMax;
                other += same ? 0 : 1;
            }
            EXPECT_LE(other * 1000, device.rays.size()) << other << " of " << device.rays.size();
        }
    }
}

// The last bounce finds what shines and sends no more rays.
TEST(PathScatter, EndsAtTheLastBounce) {
    PicturePair pair(64, 1, View::path, 3);
    pair.arrays.settings.bounces = 2;
    pair.onTwin(PictureKernels::path_scatter, {2, 0});
    for (size_t i = 0; i < pair.arrays.rays.size(); i++) {
        EXPECT_TRUE(isNoRay(pair.arrays.rays[i]));
        EXPECT_TRUE(isNoRay(pair.arrays.shadowRays[i]));
    }
}

// A path that has ended finds nothing more, whatever its old hit says.
TEST(PathScatter, LeavesEndedPathsAlone) {
    PicturePair pair(64, 1, View::path, 3);
    const PictureArrays before = pair.arrays;
    pair.onTwin(PictureKernels::path_scatter, {1, 0});
    size_t ended = 0;
    for (size_t i = 0; i < before.rays.size(); i++) {
        if (!isNoRay(before.rays[i])) continue;
        ++ended;
        EXPECT_EQ(pair.arrays.radiance[i], before.radiance[i]);
        EXPECT_EQ(pair.arrays.direct[i], vec3(0.0f));
    }
    EXPECT_GT(ended, 0u);
}

}  // namespace cleave::test
