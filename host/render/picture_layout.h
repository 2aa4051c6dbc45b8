// Where the arrays of a picture lie in scratch memory; a function of its size, view and samples.
#pragma once

#include "record/placement.h"
#include "shared/picture_args.h"

namespace cleave {

// What not every picture needs.
struct PictureParts {
    bool steps = false;    // counted, of primary rays
    bool shadows = false;  // their rays and hits
    bool paths = false;
    bool trails = false;    // for rays that may go on in a further dispatch
    bool emitters = false;  // surfaces that paths look for as lights
    uint32_t trees = 1;     // that rays visit: one trail for each
};
// What a view needs, with rays that may.
PictureParts partsOf(uint32_t view);

// Entries of the arrays in CLEAVE_PICTURE_ARRAYS: as many as there are pixels, or none, where nothing else is said.
struct PictureCounts {
    uint64_t pixels = 0;
    uint64_t trails = 0;
    uint64_t counted = 0;
    uint64_t shadowed = 0;  // shadow rays: one or two to a pixel
    uint64_t shadowTrails = 0;
    uint64_t lit = 0;
    uint64_t walked = 0;
};
PictureCounts pictureCounts(uint32_t width, uint32_t height, uint32_t view, uint32_t samples,
                            const PictureParts& parts);

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
