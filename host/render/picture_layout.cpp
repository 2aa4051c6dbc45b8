#include "render/picture_layout.h"

namespace cleave {

PictureCounts pictureCounts(uint32_t width, uint32_t height, uint32_t view, uint32_t samples) {
    PictureCounts n;
    n.pixels = uint64_t(width) * height;
    n.counted = view == kViewSteps || view == kViewLeaves ? n.pixels : 0;
    n.ofLight = isOfLight(view) ? n.pixels : 0;
    n.shadowed = view == kViewShaded && samples > 1 ? 2 * n.pixels : n.ofLight;
    n.walked = view == kViewPath ? n.pixels : 0;
    return n;
}

PictureLayout pictureLayout(const PictureCounts& n, uint64_t largestRange) {
    PictureLayout l;
    l.ranges = Placement(largestRange);
    l.args = l.ranges.place(sizeof(PictureArgs));
    l.state = l.ranges.place(sizeof(PictureState));
#define CLEAVE_PLACE(name, Element, Array, count) l.name = l.ranges.place((count) * sizeof(Element));
    CLEAVE_PICTURE_ARRAYS(CLEAVE_PLACE)
#undef CLEAVE_PLACE
    return l;
}

}  // namespace cleave
