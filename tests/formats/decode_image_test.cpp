#include "formats/decode_image.h"

#include <gtest/gtest.h>
#include <stb/stb_image_write.h>

#include "base/error.h"
#include "formats/png.h"

namespace cleave::test {
namespace {

using Bytes = std::vector<unsigned char>;

void append(void* to, void* data, int count) {
    const auto* begin = static_cast<const unsigned char*>(data);
    auto* out = static_cast<Bytes*>(to);
    out->insert(out->end(), begin, begin + count);
}

std::vector<uint32_t> pattern(uint32_t width, uint32_t height) {
    std::vector<uint32_t> pixels;
    for (uint32_t i = 0; i < width * height; ++i) pixels.push_back(i * 0x01030507u);
    return pixels;
}

Bytes png(const std::vector<uint32_t>& pixels, int width) {
    Bytes bytes;
    stbi_write_png_to_func(append, &bytes, width, static_cast<int>(pixels.size()) / width, 4, pixels.data(), 4 * width);
    return bytes;
}

TEST(DecodeImage, GivesThePixelsOfAPng) {
    const std::vector<uint32_t> pixels = pattern(7, 5);
    EXPECT_EQ(decodeImage(png(pixels, 7), 7, 5), pixels);
}

TEST(DecodeImage, GivesThePixelsOfAJpegNearly) {
    const std::vector<uint32_t> grey(16 * 8, 0xFF707070u);
    Bytes bytes;
    stbi_write_jpg_to_func(append, &bytes, 16, 8, 4, grey.data(), 95);
    for (const uint32_t p : decodeImage(bytes, 16, 8)) {
        EXPECT_NEAR(p & 255u, 0x70, 3);
        EXPECT_EQ(p >> 24, 255u);
    }
}

TEST(DecodeImage, RefusesWhatIsDamagedOrOfAnotherSize) {
    Bytes bytes = png(pattern(7, 5), 7);
    EXPECT_THROW(decodeImage(bytes, 5, 7), Error);
    bytes.resize(bytes.size() / 2);
    EXPECT_THROW(decodeImage(bytes, 7, 5), Error);
    EXPECT_THROW(decodeImage({}, 1, 1), Error);
}

}  // namespace
}  // namespace cleave::test
