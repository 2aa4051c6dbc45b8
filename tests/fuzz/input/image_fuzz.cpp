// Any bytes are an image file whose sides are in the range that is allowed, or an Error of one line.
#include "base/error.h"
#include "harness.h"
#include "scene/image_file.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    const TimeLimit limit;
    try {
        const cleave::ImageHead head = cleave::readImageHead({data, size});
        for (const uint32_t side : {head.width, head.height})
            require(side >= 1 && side <= cleave::kLargestImageSide, "a side is in its range");
        require(size > 8, "a head takes some bytes");
    } catch (const cleave::Error& error) {
        requireOneLine(error.what());
    }
    return 0;
}
