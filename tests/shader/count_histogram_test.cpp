#include <gtest/gtest.h>

#include <cstring>

#include "support/picture.h"

namespace cleave::test {

TEST(CountHistogram, EqualsTwinAtEverySizeInEveryRound) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes)
        for (const View view : {View::steps, View::leaves}) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height));
            PicturePair pair(size.width, size.height, view, seed++);
            for (uint32_t round = 0; round < 4; round++) {
                const PictureArrays device = pair.onDevice(PictureKernels::count_histogram, {round, 0});
                pair.onTwin(PictureKernels::count_histogram, {round, 0});
                ASSERT_EQ(std::memcmp(&device.state, &pair.arrays.state, sizeof(PictureState)), 0) << "round " << round;
                pair.onTwin(PictureKernels::select_count, {round, 0});
            }
        }
}

}  // namespace cleave::test
