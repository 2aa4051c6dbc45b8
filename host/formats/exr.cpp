#include "formats/exr.h"

#include <tinyexr.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>

#include "base/error.h"

namespace cleave {
namespace {

// OpenEXR stores channels in the order of their names.
constexpr std::array kNames{"B", "G", "R"};
constexpr int kChannels = static_cast<int>(kNames.size());

}  // namespace

std::vector<std::byte> exrOf(uint32_t width, uint32_t height, std::span<const glm::vec3> pixels) {
    std::array<std::vector<float>, kChannels> planes;
    for (int c = 0; c < kChannels; ++c)
        for (const glm::vec3& pixel : pixels) planes[static_cast<size_t>(c)].push_back(pixel[kChannels - 1 - c]);
    std::array<unsigned char*, kChannels> images{};
    std::array<EXRChannelInfo, kChannels> channels{};
    std::array<int, kChannels> types{};
    for (size_t c = 0; c < planes.size(); ++c) {
        images[c] = reinterpret_cast<unsigned char*>(planes[c].data());
        std::strcpy(channels[c].name, kNames[c]);
        types[c] = TINYEXR_PIXELTYPE_FLOAT;
    }
    EXRImage image;
    InitEXRImage(&image);
    image.images = images.data();
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.num_channels = kChannels;
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = kChannels;
    header.channels = channels.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;

    unsigned char* memory = nullptr;
    const char* why = nullptr;
    const size_t bytes = SaveEXRImageToMemory(&image, &header, &memory, &why);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owned(memory, &std::free);
    if (bytes == 0) {
        const std::string reason = why != nullptr ? why : "no reason is given";
        FreeEXRErrorMessage(why);
        throw Error("cannot encode the picture as OpenEXR: " + reason + "; write a .png");
    }
    const auto* first = reinterpret_cast<const std::byte*>(memory);
    return {first, first + bytes};
}

}  // namespace cleave
