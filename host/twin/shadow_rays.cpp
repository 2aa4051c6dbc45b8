#include "twin/render.h"

namespace cleave::twin {

Triangle hitTriangle(const PictureArrays& a, const Hit& hit) {
    return hit.prim == kNone ? Triangle{vec3(0.0f), vec3(0.0f), vec3(0.0f)}
                             : scaledTriangle(a.triangles[hit.prim], -a.exponent);
}

void shadowRays(PictureArrays& a, PassNumbers) {
    for (size_t i = 0; i < a.rays.size(); i++) {
        const Hit& hit = a.hits[i];
        const Triangle world = hit.prim == kNone ? Triangle{} : a.triangles[hit.prim];
        a.shadowRays[i] = shadowRay(a.rays[i], hit, world);
    }
}

}  // namespace cleave::twin
