// The encoded file of an image: its bytes, and what its head says of them. No pixel is decoded here.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace cleave {

enum class ImageFormat { png, jpeg };

// A side of a picture; one of the largest has 2^28 pixels, as much as a decoder is asked for.
constexpr uint32_t kLargestImageSide = 16384;

struct ImageHead {
    ImageFormat format = ImageFormat::png;
    uint32_t width = 0;
    uint32_t height = 0;
};

struct ImageFile {
    ImageHead head;
    std::vector<unsigned char> bytes;
};

// Reads the head of a PNG or JPEG file. Throws Error if it is neither, if the head is not all there, or if a side is 0
// or more than kLargestImageSide.
ImageHead readImageHead(std::span<const unsigned char> bytes);

// Reads the file of an image of the scene, by its URI or from its bufferView. Throws Error, which names the image, if
// that is not there or its head is refused.
ImageFile readImageFile(const Scene& scene, uint32_t image);

}  // namespace cleave
