#include "render/picture_layout.h"

namespace cleave {

PictureParts partsOf(uint32_t view) {
    return {view == kViewSteps || view == kViewLeaves, isOfLight(view), view == kViewPath, true, false};
}

PictureCounts pictureCounts(uint32_t width, uint32_t height, uint32_t view, uint32_t samples,
                            const PictureParts& parts) {
    PictureCounts n;
    n.pixels = uint64_t(width) * height;
    n.trails = parts.trails ? parts.trees * n.pixels : 0;
    n.counted = parts.steps ? n.pixels : 0;
    n.shadowed = !parts.shadows ? 0 : view == kViewShaded && samples > 1 ? 2 * n.pixels : n.pixels;
    n.shadowTrails = parts.trails ? parts.trees * n.shadowed : 0;
    n.lit = isOfLight(view) ? n.pixels : 0;
    n.walked = parts.paths ? n.pixels : 0;
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
