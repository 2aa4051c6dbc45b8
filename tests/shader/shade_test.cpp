#include <gtest/gtest.h>

#include "support/picture.h"
#include "twin/render.h"

namespace cleave::test {

TEST(Shade, EqualsTwinAtEverySizeInEveryView) {
    for (uint32_t n : kSizes) {
        PictureInput in(n, n + 1);
        for (uint32_t view : {kViewShaded, kViewNormals, kViewDepth, kViewSteps, kViewLeaves}) {
            SCOPED_TRACE("pixels " + std::to_string(n) + ", view " + std::to_string(view));
            const std::vector<uint32_t> device = in.pixelsOnDevice(view);
            const std::vector<uint32_t> twin = twin::shade(in.arrays(), view, in.low, in.high);
            ASSERT_EQ(device.size(), twin.size());
            for (size_t i = 0; i < n; i++)
                for (uint32_t shift = 0; shift < 32; shift += 8) {
                    const int a = static_cast<int>(device[i] >> shift & 255);
                    const int b = static_cast<int>(twin[i] >> shift & 255);
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
