// Any bytes are an image file whose sides are in the range that is allowed and, if it is a small one, whose pixels are
// all there, or an Error of one line.
#include "base/error.h"
#include "formats/decode_image.h"
#include "harness.h"
#include "scene/image_file.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    constexpr size_t kMostPixels = 1 << 18;
    const TimeLimit limit;
    try {
        const cleave::ImageHead head = cleave::readImageHead({data, size});
        for (const uint32_t side : {head.width, head.height})
            require(side >= 1 && side <= cleave::kLargestImageSide, "a side is in its range");
        require(size > 8, "a head takes some bytes");
        const size_t pixels = size_t{head.width} * head.height;
        if (pixels > kMostPixels) return 0;
        require(cleave::decodeImage({data, size}, head.width, head.height).size() == pixels, "every pixel is there");
    } catch (const cleave::Error& error) {
        requireOneLine(error.what());
    }
    return 0;
}
