#include "twin/render.h"

namespace cleave::twin {

Triangle hitTriangle(const PictureArrays& a, const Hit& hit) {
    return hit.prim == kNone ? Triangle{vec3(0.0f), vec3(0.0f), vec3(0.0f)}
                             : scaledTriangle(a.triangles[hit.prim], -a.exponent);
}

void shadowRays(PictureArrays& a, uint32_t) {
    const float offset = shadowOffset(a.bounds, a.exponent);
    for (size_t i = 0; i < a.rays.size(); i++)
        a.shadowRays[i] = shadowRay(a.rays[i], a.hits[i], hitTriangle(a, a.hits[i]), offset);
}

}  // namespace cleave::twin
