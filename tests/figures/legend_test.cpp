#include "figures/legend.h"

#include <gtest/gtest.h>

#include <set>

#include "shared/shade.h"

namespace cleave::test {
namespace {

Picture greyPicture(uint32_t width, uint32_t height, float low, float high) {
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.pixels.assign(size_t{width} * height, 0xFF808080u);
    picture.scaleLow = low;
    picture.scaleHigh = high;
    return picture;
}

// Which pixels of the lower left panel are drawn white by `high` alone.
std::vector<uint32_t> legendOf(float high) {
    Picture picture = greyPicture(200, 100, 0.0f, high);
    drawLegend(picture);
    return picture.pixels;
}

TEST(Legend, ShowsTheNumbers) {
    std::set<std::vector<uint32_t>> all;
    for (int digit = 0; digit < 10; ++digit) all.insert(legendOf(static_cast<float>(digit)));
    EXPECT_EQ(all.size(), 10u) << "every digit has its own shape";
    EXPECT_EQ(legendOf(12.0f), legendOf(12.4f)) << "counts are whole";
    // The left stroke of the 1 of "17", which ends at dot 99 of the panel: two digits of 5 dots and a gap.
    const std::vector<uint32_t> pixels = legendOf(17.0f);
    EXPECT_EQ(pixels[(100 - 23 + 3) * 200 + 3 + 96 - 11 + 2], 0xFFFFFFFFu);
}

TEST(Legend, StaysInItsCorner) {
    Picture picture = greyPicture(200, 100, 0.0f, 99999999.0f);
    drawLegend(picture);
    size_t changed = 0;
    for (uint32_t y = 0; y < 100; ++y)
        for (uint32_t x = 0; x < 200; ++x) {
            const bool inside = x < 102 && y >= 77;
            EXPECT_TRUE(inside || picture.pixels[y * 200 + x] == 0xFF808080u) << x << ", " << y;
            changed += picture.pixels[y * 200 + x] != 0xFF808080u;
        }
    EXPECT_GT(changed, 2000u);
}

TEST(Legend, ShowsTheColoursOfTheScale) {
    const std::vector<uint32_t> pixels = legendOf(9.0f);
    const size_t row = 100 - 23 + 3 + 7 + 2;
    EXPECT_EQ(pixels[row * 200 + 3], packedColour(scaleColour(0.0f)));
    EXPECT_EQ(pixels[row * 200 + 3 + 95], packedColour(scaleColour(1.0f)));
}

TEST(Legend, LeavesASmallPictureAlone) {
    Picture picture = greyPicture(101, 100, 0.0f, 9.0f);
    drawLegend(picture);
    EXPECT_EQ(picture.pixels, greyPicture(101, 100, 0.0f, 9.0f).pixels);
}

}  // namespace
}  // namespace cleave::test
