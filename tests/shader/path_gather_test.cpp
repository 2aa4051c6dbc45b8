#include <gtest/gtest.h>

#include "support/picture.h"

namespace cleave::test {

TEST(PathGather, EqualsTwinAtEverySize) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height));
        PicturePair pair(size.width, size.height, View::path, seed++);
        const std::vector<vec3> before = pair.arrays.radiance;
        const std::vector<vec3> device = pair.onDevice(PictureKernels::path_gather).radiance;
        pair.onTwin(PictureKernels::path_gather);
        EXPECT_EQ(device, pair.arrays.radiance);
        for (size_t i = 0; i < before.size(); i++) {
            const uint32_t path = pair.arrays.shadowPaths[i];
            EXPECT_EQ(device[path] != before[path], pair.arrays.shadowHits[i].prim == kNone)
                << "what is in shadow gains nothing";
        }
    }
}

}  // namespace cleave::test
