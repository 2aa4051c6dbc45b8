#include "twin/render.h"

namespace cleave::twin {

void countHistogram(PictureArrays& a, PassNumbers numbers) {
    const uint32_t shift = 24 - 8 * numbers.round;
    for (size_t i = 0; i < a.rays.size(); i++) {
        if (!countsInScale(a.view, a.hits[i])) continue;
        const uint64_t count = shownCount(a.view, a.steps[i]);
        if (count >> (shift + 8) == a.state.prefix) a.state.histogram[count >> shift & 255]++;
    }
}

}  // namespace cleave::twin
