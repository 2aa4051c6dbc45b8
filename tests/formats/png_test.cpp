#include "formats/png.h"

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include "base/error.h"

namespace cleave::test {
namespace {

TEST(Png, HoldsThePixels) {
    std::vector<uint32_t> pixels(35);
    for (uint32_t i = 0; i < pixels.size(); ++i) pixels[i] = 0xFF000000u | i * 0x010305u;
    const std::vector<std::byte> png = pngOf(7, 5, pixels);
    int width = 0;
    int height = 0;
    int channels = 0;
    stbi_uc* got = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()),
                                         &width, &height, &channels, 3);
    ASSERT_NE(got, nullptr);
    EXPECT_EQ(width, 7);
    EXPECT_EQ(height, 5);
    EXPECT_EQ(channels, 3);
    for (size_t i = 0; i < pixels.size(); ++i)
        EXPECT_EQ(got[3 * i] | got[3 * i + 1] << 8 | got[3 * i + 2] << 16, static_cast<int>(pixels[i] & 0xFFFFFF)) << i;
    stbi_image_free(got);
}

TEST(Png, RefusesSizesThatDoNotFitThePixels) {
    EXPECT_THROW(pngOf(2, 2, std::vector<uint32_t>(3)), Error);
    EXPECT_THROW(pngOf(0, 0, {}), Error);
}

}  // namespace
}  // namespace cleave::test
