// Pixels of PNG and JPEG files.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave {

// Decodes a file to R | G << 8 | B << 16 | A << 24, row by row from the top; 16-bit components are cut to 8, and what
// the file says of gamma and colour profiles is ignored, as glTF asks (section 3.8.3). Throws Error if that cannot be
// done or gives another size, which the caller has read from the file's head and found affordable.
std::vector<uint32_t> decodeImage(std::span<const unsigned char> bytes, uint32_t width, uint32_t height);

}  // namespace cleave
