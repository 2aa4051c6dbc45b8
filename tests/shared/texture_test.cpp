#include "shared/texture.h"

#include <gtest/gtest.h>

#include <vector>

namespace cleave::test {
namespace {

// Red counts columns and green counts rows, in steps of 10.
struct Image {
    std::vector<uint32_t> texels;
    TextureMap map{};

    Image(uint32_t width, uint32_t height, uint32_t flags) {
        texels.assign(3, 0);  // another image before it
        map.first = 3;
        map.width = width;
        map.height = height;
        map.flags = flags;
        map.turn = {1, 0, 0, 1};
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) texels.push_back(10 * x | 10 * y << 8 | 0x80FF0000u);
    }
    vec4 at(float u, float v) const { return sampledTexture({texels.data()}, map, {u, v}) * 255.0f; }
    float column(float u) const { return at(u, 0.01f).x / 10.0f; }
    float row(float v) const { return at(0.01f, v).y / 10.0f; }
};

TEST(Texture, BeginsAtTheTopLeft) {
    const Image image(4, 2, kMapNearest);
    const vec4 first = image.at(0.1f, 0.1f), last = image.at(0.9f, 0.9f);
    EXPECT_NEAR(first.x, 0, 1e-4f);
    EXPECT_NEAR(first.y, 0, 1e-4f);
    EXPECT_NEAR(first.z, 255, 1e-4f);
    EXPECT_NEAR(first.w, 128, 1e-4f);
    EXPECT_NEAR(last.x, 30, 1e-4f);
    EXPECT_NEAR(last.y, 10, 1e-4f);
}

TEST(Texture, NearestTakesTheTexelThatTheCoordinateIsIn) {
    const Image image(4, 4, kMapNearest);
    EXPECT_NEAR(image.column(0.2499f), 0, 1e-4f);
    EXPECT_NEAR(image.column(0.2501f), 1, 1e-4f);
}

// The centre of texel i of n is at (i + 1/2) / n.
TEST(Texture, LinearGoesFromCentreToCentre) {
    const Image image(4, 4, kMapClampS | kMapClampT);
    EXPECT_NEAR(image.column(0.375f), 1, 1e-4f);
    EXPECT_NEAR(image.column(0.5f), 1.5f, 1e-4f);
    EXPECT_NEAR(image.row(0.4375f), 1.25f, 1e-4f);
}

TEST(Texture, WrapsAsItsSamplerSays) {
    const auto columns = [](uint32_t flags, std::vector<float> places) {
        const Image image(4, 1, flags | kMapNearest);
        std::vector<int> found;
        for (const float u : places) found.push_back(static_cast<int>(std::lround(image.column(u))));
        return found;
    };
    const std::vector<float> places = {-1.1f, -0.6f, -0.1f, 0.1f, 0.9f, 1.1f, 1.6f, 2.1f};
    EXPECT_EQ(columns(0, places), (std::vector<int>{3, 1, 3, 0, 3, 0, 2, 0}));
    EXPECT_EQ(columns(kMapClampS, places), (std::vector<int>{0, 0, 0, 0, 3, 3, 3, 3}));
    EXPECT_EQ(columns(kMapMirrorS, places), (std::vector<int>{3, 2, 0, 0, 3, 3, 1, 0}));
}

TEST(Texture, LinearWrapsEachOfItsTexels) {
    EXPECT_NEAR(Image(4, 4, 0).column(0.0f), 1.5f, 1e-4f) << "between the last and the first";
    EXPECT_NEAR(Image(4, 4, kMapClampS).column(0.0f), 0, 1e-4f);
    EXPECT_NEAR(Image(4, 4, kMapMirrorS).column(1.0f), 3, 1e-4f);
    EXPECT_NEAR(Image(4, 4, kMapMirrorT).row(1.0f), 3, 1e-4f);
}

// Coordinates come from a file and may be anything; addresses stay within the image.
TEST(Texture, StaysInItsImageWhateverTheCoordinates) {
    const float wild[] = {infinity(), -infinity(), std::nanf(""), 3.4e38f, -3.4e38f, 1e6f, -16777217.0f, 1e-38f};
    for (const uint32_t flags : {0u, kMapClampS | kMapClampT, kMapMirrorS | kMapMirrorT, kMapNearest})
        for (const float u : wild)
            for (const float v : wild) {
                const Image image(3, 5, flags);
                const vec4 colour = image.at(u, v);
                EXPECT_NEAR(colour.z, 255.0f, 1e-3f) << u << " " << v << ": a texel of the image";
                EXPECT_NEAR(colour.w, 128.0f, 1e-3f);
            }
    EXPECT_EQ(wrappedPlace(-1.0f, 1, false, true), 0u);
}

TEST(Texture, DecodesColoursAndLeavesAlpha) {
    Image image(1, 1, kMapSrgb);
    image.texels[3] = 0x80FF0080u;
    const vec4 c = image.at(0.5f, 0.5f);
    EXPECT_NEAR(c.x, 0.2158605f * 255, 1e-3f);  // 128 of 255, IEC 61966-2-1
    EXPECT_EQ(c.y, 0.0f);
    EXPECT_NEAR(c.z, 255, 1e-3f);
    EXPECT_NEAR(c.w, 128, 1e-4f);
    EXPECT_NEAR(decoded(0.04045f), 0.0031308f, 1e-6f);
}

TEST(Texture, TransformsCoordinates) {
    Image image(4, 4, kMapNearest);
    image.map.turn = {0, 1, -1, 0};
    image.map.offset = {0.25f, 1.0f};
    const vec4 c = image.at(0.6f, 0.1f);  // (0.1 + 0.25, -0.6 + 1)
    EXPECT_NEAR(c.x / 10, 1, 1e-4f);
    EXPECT_NEAR(c.y / 10, 1, 1e-4f);
}

}  // namespace
}  // namespace cleave::test
