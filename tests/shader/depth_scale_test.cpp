#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

TEST(DepthScale, EqualsTwinAtEverySize) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height));
        PicturePair pair(size.width, size.height, View::depth, seed++);
        const PictureArrays device = pair.onDevice(PictureKernels::depth_scale);
        pair.onTwin(PictureKernels::depth_scale);
        EXPECT_EQ(device.state.lowBits, pair.arrays.state.lowBits);
        EXPECT_EQ(device.state.highBits, pair.arrays.state.highBits);
    }
}

// A ray along +x enters a box from -1 to 3 at -5: it leaves at t = 8 in world units, wherever it hits before.
TEST(DepthScale, ReachesToWhereTheRayLeavesTheBox) {
    const Box box{{-0.25f, -0.25f, -0.25f}, {0.75f, 0.25f, 0.25f}};  // scaled by 2^-2
    const Ray ray{{-5, 0, 0}, 0, {1, 0, 0}, infinity()};
    EXPECT_EQ(depthReach(ray, Hit{4.5f, 0, 0, 0}, box, 2), 8.0f);
    EXPECT_EQ(depthReach(ray, Hit{9.0f, 0, 0, 0}, box, 2), 9.0f) << "never nearer than the hit";
    EXPECT_EQ(viewScale(~orderedBits(2.0f), orderedBits(8.0f)).low, 2.0f);
    EXPECT_EQ(viewScale(~orderedBits(2.0f), orderedBits(8.0f)).high, 8.0f);
    EXPECT_EQ(viewScale(0, 0).high, 0.0f) << "nothing was hit";
}

}  // namespace cleave::test
