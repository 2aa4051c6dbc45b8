// Input for the kernels of a picture, made from a seed, on both sides.
#pragma once

#include "render/cmd_render.h"
#include "run/ranges.h"
#include "run/renderer.h"
#include "support/device.h"
#include "support/scenes.h"
#include "twin/render.h"

namespace cleave::test {

class PicturePair {
  public:
    // The seed also says which parts surfaces have: eight that follow one another have all there are.
    PicturePair(uint32_t width, uint32_t height, View view, uint32_t seed, uint32_t samples = 1);

    PictureArrays arrays;  // the twin's

    // Runs a pass on the device with the arrays as they are now; what it leaves there.
    PictureArrays onDevice(PictureKernels::Pass pass, PassNumbers numbers = {});
    // Runs its twin, which changes `arrays`.
    void onTwin(PictureKernels::Pass pass, PassNumbers numbers = {});

  private:
    Buffer triangles_, lights_, emitters_, albedo_;
    std::unique_ptr<DeviceSurfaces> surfaces_;
    RangeBuffers scratch_;
    PictureLayout at_;
};

// Sizes of pictures: below, at and above a tile, a strip, a workgroup.
struct PictureSize {
    uint32_t width;
    uint32_t height;
};
constexpr PictureSize kPictureSizes[] = {{1, 1}, {7, 3}, {8, 8}, {9, 8}, {8, 9}, {64, 1}, {65, 65}, {257, 130}};

}  // namespace cleave::test
