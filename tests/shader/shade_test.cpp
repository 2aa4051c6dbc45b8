#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

TEST(Shade, EqualsTwinAtEverySizeInEveryView) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        for (const View view : {View::shaded, View::normals, View::depth, View::steps, View::leaves}) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", view " +
                         std::to_string(static_cast<uint32_t>(view)));
            PicturePair pair(size.width, size.height, view, seed++);
            pair.arrays.state.lowBits = ~orderedBits(0.5f);
            pair.arrays.state.highBits = orderedBits(40.0f);
            const std::vector<uint32_t> device = pair.onDevice(PictureKernels::shade).pixels;
            pair.onTwin(PictureKernels::shade);
            for (size_t i = 0; i < device.size(); i++)
                for (uint32_t shift = 0; shift < 32; shift += 8) {
                    const int a = static_cast<int>(device[i] >> shift & 255);
                    const int b = static_cast<int>(pair.arrays.pixels[i] >> shift & 255);
                    ASSERT_LE(std::abs(a - b), 1) << "pixel " << i << ", channel " << shift / 8;  // rounding of pow
                }
        }
    }
}

TEST(Shade, HandWorkedColours) {
    EXPECT_EQ(packedColour({1.0f, 0.0f, 0.5f}), 0xFF8000FFu);
    EXPECT_NEAR(encoded(0.5f), 0.735357f, 1e-5f);  // IEC 61966-2-1
    EXPECT_NEAR(encoded(0.002f), 0.02584f, 1e-6f);
    EXPECT_EQ(onScale(3.0f, 1.0f, 5.0f), 0.5f);
    EXPECT_EQ(onScale(9.0f, 1.0f, 5.0f), 1.0f);
    EXPECT_EQ(onScale(9.0f, 1.0f, 1.0f), 0.0f);
    const Triangle t{{0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}};
    EXPECT_EQ(facingNormal(t, {0, 0, 1}), glm::vec3(0, 0, -1));
    EXPECT_EQ(facingNormal(t, {0, 0, -1}), glm::vec3(0, 0, 1));
    const glm::vec3 lit = shadedColour({1, 1, 1}, towardsSun(), true);
    const glm::vec3 shadow = shadedColour({1, 1, 1}, towardsSun(), false);
    EXPECT_NEAR(lit.x - shadow.x, kSunLight, 1e-6f);
}

}  // namespace cleave::test
