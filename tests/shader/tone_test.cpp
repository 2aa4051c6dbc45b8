#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

TEST(Tone, EqualsTwinAtEverySizeInEveryView) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        for (const View view : {View::shaded, View::normals, View::depth, View::path}) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", view " +
                         std::to_string(static_cast<uint32_t>(view)));
            PicturePair pair(size.width, size.height, view, seed++);
            pair.arrays.exposure = 1.7f;
            const std::vector<uint32_t> device = pair.onDevice(PictureKernels::tone, {0, 3}).pixels;
            pair.onTwin(PictureKernels::tone, {0, 3});
            for (size_t i = 0; i < device.size(); i++)
                for (uint32_t shift = 0; shift < 32; shift += 8) {
                    const int a = static_cast<int>(device[i] >> shift & 255);
                    const int b = static_cast<int>(pair.arrays.pixels[i] >> shift & 255);
                    ASSERT_LE(std::abs(a - b), 1) << "pixel " << i << ", channel " << shift / 8;  // rounding of pow
                }
        }
    }
}

// By the formulas of its specification: below 0.08 the square, then 0.04 less; 0.8 - 0.04 is where it begins to bend.
TEST(Tone, HandWorkedCurve) {
    EXPECT_EQ(neutralTone(vec3(0.0f)), vec3(0.0f));
    EXPECT_NEAR(neutralTone(vec3(0.04f)).x, 6.25f * 0.04f * 0.04f, 1e-6f);
    EXPECT_NEAR(neutralTone(vec3(0.5f)).x, 0.46f, 1e-6f);
    EXPECT_NEAR(neutralTone(vec3(0.79f)).x, 0.75f, 1e-6f);
    EXPECT_NEAR(neutralTone(vec3(1.04f)).x, 1.0f - 0.24f * 0.24f / 0.48f, 1e-6f);
    const vec3 red = neutralTone({0.5f, 0.1f, 0.1f});
    EXPECT_NEAR(red.x, 0.46f, 1e-6f);
    EXPECT_NEAR(red.y, 0.06f, 1e-6f);
    const vec3 bright = neutralTone({100.0f, 1.0f, 1.0f});
    EXPECT_LT(bright.x, 1.0f);
    EXPECT_GT(bright.y, 0.5f) << "what is far too bright turns white";
}

TEST(Tone, OnlyLightIsExposed) {
    const vec4 none(0.0f);
    EXPECT_EQ(shownColour(kViewNormals, vec3(0.5f), none, 2, 4.0f), vec3(0.25f));
    EXPECT_EQ(shownColour(kViewShaded, vec3(0.5f), none, 2, 2.0f), encoded(vec3(0.5f)));
    EXPECT_EQ(shownColour(kViewPath, vec3(0.5f), none, 2, 2.0f), encoded(neutralTone(vec3(0.5f))));
}

// A pixel of four samples: all of them unlit, one of them, and one beside light that is far too bright.
TEST(Tone, UnlitColoursPassThrough) {
    const vec3 colour(0.25f, 0.5f, 1.0f);
    for (const uint view : {kViewShaded, kViewPath})
        for (const float exposure : {0.125f, 1.0f, 8.0f})
            EXPECT_EQ(shownColour(view, vec3(0.0f), vec4(colour * 4.0f, 4.0f), 4, exposure), encoded(colour));
    const vec3 one = shownColour(kViewPath, vec3(0.9f), vec4(colour, 1.0f), 4, 2.0f);
    const vec3 bright = shownColour(kViewShaded, vec3(300.0f), vec4(colour, 1.0f), 4, 2.0f);
    for (int k = 0; k < 3; k++) {
        EXPECT_NEAR(one[k], encoded(0.75f * neutralTone(vec3(0.6f))[k] + 0.25f * colour[k]), 1e-6f);
        EXPECT_NEAR(bright[k], encoded(0.75f + 0.25f * colour[k]), 1e-6f);
    }
}

}  // namespace cleave::test
