#include "formats/png.h"

#include <stb_image_write.h>

#include <climits>
#include <string>

#include "base/error.h"

namespace cleave {

std::vector<std::byte> pngOf(uint32_t width, uint32_t height, std::span<const uint32_t> pixels) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    // stb counts bytes with int.
    if (uint64_t{width} * height != pixels.size() || pixels.empty() || pixels.size() > INT_MAX / 4)
        throw Error("cannot write a picture of " + size + " pixels; choose another size");
    std::vector<unsigned char> rgb;
    rgb.reserve(3 * pixels.size());
    for (const uint32_t p : pixels)
        for (const int shift : {0, 8, 16}) rgb.push_back(static_cast<unsigned char>(p >> shift & 0xFFu));
    std::vector<std::byte> bytes;
    const auto append = [](void* to, void* data, int count) {
        const auto* begin = static_cast<const std::byte*>(data);
        auto* out = static_cast<std::vector<std::byte>*>(to);
        out->insert(out->end(), begin, begin + count);
    };
    const int w = static_cast<int>(width);
    if (stbi_write_png_to_func(append, &bytes, w, static_cast<int>(height), 3, rgb.data(), 3 * w) == 0)
        throw Error("cannot encode a picture of " + size + " pixels: memory ran out; choose a smaller size");
    return bytes;
}

}  // namespace cleave
