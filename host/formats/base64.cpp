#include "formats/base64.h"

#include <array>
#include <cstdint>

#include "base/error.h"

namespace cleave {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64Of(std::span<const std::byte> bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? std::to_integer<uint32_t>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

std::vector<std::byte> bytesOfBase64(std::string_view text) {
    size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
    if (text.size() % 4 != 0) throw Error("a text in base64 is cut short; make it again");
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (size_t i = 0; i < text.size(); i += 4) {
        uint32_t group = 0;
        for (size_t k = 0; k < 4; ++k) {
            const bool isPadding = i + k >= text.size() - padding;
            const size_t digit = isPadding ? 0 : kDigits.find(text[i + k]);
            if (digit == std::string_view::npos) throw Error("a text in base64 has a character that is none of it");
            group = group << 6 | static_cast<uint32_t>(digit);
        }
        for (int shift = 16; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(group >> shift & 255u));
    }
    bytes.resize(bytes.size() - padding);
    return bytes;
}

}  // namespace cleave
