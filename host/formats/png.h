// Pictures as PNG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cleave {

// Pixels are R | G << 8 | B << 16 | A << 24, row by row from the top; written as opaque 8-bit RGB. Throws Error.
std::vector<std::byte> pngOf(uint32_t width, uint32_t height, std::span<const uint32_t> pixels);

}  // namespace cleave
