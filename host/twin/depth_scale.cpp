#include "twin/render.h"

namespace cleave::twin {

void depthScale(PictureArrays& a, PassNumbers) {
    for (size_t i = 0; i < a.rays.size(); i++) {
        if (a.hits[i].prim == kNone) continue;
        const float reach = depthReach(a.rays[i], a.hits[i], a.bounds, a.exponent);
        a.state.lowBits = std::max(a.state.lowBits, ~orderedBits(a.hits[i].t));
        a.state.highBits = std::max(a.state.highBits, orderedBits(reach));
    }
}

}  // namespace cleave::twin
