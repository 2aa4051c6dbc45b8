#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

TEST(Shade, EqualsTwinAtEverySizeInEveryView) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        for (const View view : {View::shaded, View::normals, View::depth, View::steps, View::leaves}) {
            SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", view " +
                         std::to_string(static_cast<uint32_t>(view)));
            PicturePair pair(size.width, size.height, view, seed, 1 + seed / 8 % 2);
            seed++;
            pair.arrays.state.lowBits = ~orderedBits(0.5f);
            pair.arrays.state.highBits = orderedBits(40.0f);
            for (const uint32_t sample : {0u, 2u}) {
                const PictureArrays device = pair.onDevice(PictureKernels::shade, {0, sample});
                pair.onTwin(PictureKernels::shade, {0, sample});
                ASSERT_EQ(device.unlit.size(), pair.arrays.unlit.size());
                for (size_t i = 0; i < device.unlit.size(); i++) {
                    for (int k = 0; k < 3; k++)
                        ASSERT_NEAR(device.unlit[i][k], pair.arrays.unlit[i][k], 1e-5f) << "ray " << i;
                    ASSERT_EQ(device.unlit[i].w, pair.arrays.unlit[i].w) << "ray " << i;
                }
                for (size_t i = 0; i < device.rays.size(); i++)  // square roots and quotients may round differently
                    for (int k = 0; k < 3; k++)
                        ASSERT_NEAR(device.radiance[i][k], pair.arrays.radiance[i][k], 1e-5f) << "ray " << i;
            }
        }
    }
}

// Where the step limit ended rays, nothing is added until they are answered.
TEST(Shade, WaitsForUnfinishedRays) {
    for (TraceCounters PictureState::*counters : {&PictureState::primary, &PictureState::shadow}) {
        PicturePair pair(9, 8, View::shaded, 1);
        (pair.arrays.state.*counters).unfinishedRays = 1;
        EXPECT_EQ(pair.onDevice(PictureKernels::shade).radiance, pair.arrays.radiance);
        const std::vector<vec3> before = pair.arrays.radiance;
        pair.onTwin(PictureKernels::shade);
        EXPECT_EQ(pair.arrays.radiance, before);
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
    HitSurface white{};
    white.facing = white.normal = towardsSun();
    white.baseColour = vec4(1.0f);
    white.occlusion = 1.0f;
    const vec3 sun = towardsSun();
    const vec3 shadow = shadedColour(white, sun, false, true);
    EXPECT_NEAR(shadedColour(white, sun, true, true).x - shadow.x, kSunLight, 1e-6f);
    EXPECT_EQ(shadedColour(white, sun, false, false), vec3(0.0f)) << "and the light from around is kept away";
    EXPECT_NEAR(shadedColour(white, {0.0f, 1.0f, 0.0f}, true, false).x, kSunLight * sun.y, 1e-6f);
    white.occlusion = 0.0f;
    white.emission = {0.0f, 0.5f, 0.0f};
    EXPECT_EQ(shadedColour(white, sun, false, true), vec3(0.0f, 0.5f, 0.0f));
    white.normal.y = -white.normal.y;  // as corners bend it; the triangle itself turns away
    white.facing = -white.facing;
    EXPECT_EQ(shadedColour(white, sun, true, true), vec3(0.0f, 0.5f, 0.0f))
        << "the sun does not shine through a triangle";
    white.flags = kMaterialUnlit;
    EXPECT_EQ(shadedColour(white, sun, true, true), vec3(1.0f));
    EXPECT_EQ(shadedColour(white, sun, false, false), vec3(1.0f));
}

}  // namespace cleave::test
