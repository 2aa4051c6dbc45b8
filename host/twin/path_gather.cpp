#include "twin/render.h"

namespace cleave::twin {

void pathGather(PictureArrays& a, PassNumbers) {
    for (size_t i = 0; i < a.rays.size(); i++)
        if (a.shadowHits[i].prim == kNone) a.radiance[a.shadowPaths[i]] += a.direct[i];
}

}  // namespace cleave::twin
