#include "figures/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "shared/shade.h"

namespace cleave {
namespace {

// Digits of 5 x 7 dots, a row per byte, the leftmost dot in bit 4.
constexpr uint32_t kDigitWidth = 5;
constexpr uint32_t kDigitHeight = 7;
constexpr std::array<std::array<uint8_t, kDigitHeight>, 10> kDigits = {{{0x0E, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0E},
                                                                        {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E},
                                                                        {0x0E, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1F},
                                                                        {0x1F, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0E},
                                                                        {0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02},
                                                                        {0x1F, 0x10, 0x1E, 0x01, 0x01, 0x11, 0x0E},
                                                                        {0x06, 0x08, 0x10, 0x1E, 0x11, 0x11, 0x0E},
                                                                        {0x1F, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08},
                                                                        {0x0E, 0x11, 0x11, 0x0E, 0x11, 0x11, 0x0E},
                                                                        {0x0E, 0x11, 0x11, 0x0F, 0x01, 0x02, 0x0C}}};

// All lengths in dots; a dot is a square of pixels, larger in larger pictures.
constexpr uint32_t kMargin = 3;
constexpr uint32_t kBarWidth = 96;
constexpr uint32_t kBarHeight = 8;
constexpr uint32_t kGap = 2;
constexpr uint32_t kPanelWidth = kBarWidth + 2 * kMargin;
constexpr uint32_t kPanelHeight = kMargin + kDigitHeight + kGap + kBarHeight + kMargin;
constexpr uint32_t kPicturePerDot = 240;  // pixels of the picture's height for each pixel of a dot

constexpr uint32_t kBlack = 0xFF000000u;
constexpr uint32_t kWhite = 0xFFFFFFFFu;

class Panel {
  public:
    explicit Panel(Picture& picture) : picture_(picture), dot_(std::max(1u, picture.height / kPicturePerDot)) {}

    bool fits() const { return kPanelWidth * dot_ <= picture_.width && kPanelHeight * dot_ <= picture_.height; }

    void fill(uint32_t x, uint32_t y, uint32_t width, uint32_t height, uint32_t colour) {
        const uint32_t top = picture_.height - kPanelHeight * dot_;
        for (uint32_t py = y * dot_; py < (y + height) * dot_; ++py)
            for (uint32_t px = x * dot_; px < (x + width) * dot_; ++px)
                picture_.pixels[size_t{top + py} * picture_.width + px] = colour;
    }

    void number(uint32_t x, uint32_t y, const std::string& digits) {
        for (const char c : digits) {
            const auto& rows = kDigits[static_cast<size_t>(c - '0')];
            for (uint32_t row = 0; row < kDigitHeight; ++row)
                for (uint32_t column = 0; column < kDigitWidth; ++column)
                    if ((rows[row] >> (kDigitWidth - 1 - column) & 1) != 0) fill(x + column, y + row, 1, 1, kWhite);
            x += kDigitWidth + 1;
        }
    }

  private:
    Picture& picture_;
    uint32_t dot_;
};

std::string digitsOf(float count) { return std::to_string(std::llround(std::clamp(count, 0.0f, 99999999.0f))); }

}  // namespace

void drawLegend(Picture& picture) {
    Panel panel(picture);
    if (!panel.fits()) return;
    panel.fill(0, 0, kPanelWidth, kPanelHeight, kBlack);
    const std::string low = digitsOf(picture.scaleLow);
    const std::string high = digitsOf(picture.scaleHigh);
    const auto highWidth = static_cast<uint32_t>(high.size()) * (kDigitWidth + 1) - 1;
    panel.number(kMargin, kMargin, low);
    panel.number(kMargin + kBarWidth - highWidth, kMargin, high);
    for (uint32_t x = 0; x < kBarWidth; ++x) {
        const float along = static_cast<float>(x) / static_cast<float>(kBarWidth - 1);
        panel.fill(kMargin + x, kMargin + kDigitHeight + kGap, 1, kBarHeight, packedColour(scaleColour(along)));
    }
}

}  // namespace cleave
