#include "formats/decode_image.h"

#include <stb_image.h>

#include <climits>
#include <cstring>
#include <memory>
#include <string>

#include "base/error.h"

namespace cleave {

std::vector<uint32_t> decodeImage(std::span<const unsigned char> bytes, uint32_t width, uint32_t height) {
    constexpr int kChannels = 4;
    if (bytes.size() > INT_MAX) throw Error("the file has more than 2 GiB; scale the image");
    int columns = 0, rows = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> decoded(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &columns, &rows, &channels, kChannels),
        &stbi_image_free);
    if (!decoded)
        throw Error(std::string("its pixels cannot be decoded (") + stbi_failure_reason() + "); save it anew");
    if (static_cast<uint32_t>(columns) != width || static_cast<uint32_t>(rows) != height)
        throw Error("its pixels are not as many as its head says; save it anew");
    std::vector<uint32_t> pixels(size_t{width} * height);
    std::memcpy(pixels.data(), decoded.get(), pixels.size() * sizeof(uint32_t));  // bytes R, G, B, A: little-endian
    return pixels;
}

}  // namespace cleave
