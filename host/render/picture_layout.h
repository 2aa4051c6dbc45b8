// Where the arrays of a picture lie in scratch memory; a function of its size, view and samples.
#pragma once

#include "record/placement.h"
#include "shared/picture_args.h"

namespace cleave {

// Entries of the arrays in CLEAVE_PICTURE_ARRAYS.
struct PictureCounts {
    uint64_t pixels = 0;
    uint64_t counted = 0;   // pixels, in views of counts
    uint64_t ofLight = 0;   // pixels, in the views of light
    uint64_t shadowed = 0;  // shadow rays: one or two to a pixel, in the views of light
    uint64_t walked = 0;    // pixels, in the view of paths
};
PictureCounts pictureCounts(uint32_t width, uint32_t height, uint32_t view, uint32_t samples);

// Arguments and state are in range 0.
struct PictureLayout {
    Place args, state;
#define CLEAVE_PLACE_FIELD(name, Element, Array, count) Place name;
    CLEAVE_PICTURE_ARRAYS(CLEAVE_PLACE_FIELD)
#undef CLEAVE_PLACE_FIELD
    Placement ranges{0};
};
PictureLayout pictureLayout(const PictureCounts& n, uint64_t largestRange);

}  // namespace cleave
