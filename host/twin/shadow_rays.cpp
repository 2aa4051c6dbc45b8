#include "shared/light_rays.h"

#include "twin/render.h"

namespace cleave::twin {

Triangle hitTriangle(const PictureArrays& a, const Hit& hit) {
    return hit.prim == kNone ? Triangle{vec3(0.0f), vec3(0.0f), vec3(0.0f)}
                             : scaledTriangle(a.triangles[hit.prim], -a.exponent);
}

void shadowRays(PictureArrays& a, PassNumbers numbers) {
    const size_t pixels = a.rays.size();
    for (uint32_t i = 0; i < pixels; i++) {
        const Hit& hit = a.hits[i];
        LightRays made = noLightRays();
        if (hit.prim != kNone)
            made = lightRays(a.rays[i], hit, a.triangles[hit.prim], hitTriangle(a, hit), a.samples, a.ambientReach,
                             pixelOf(i, a.camera.width, a.camera.height), numbers.path ^ a.settings.seed);
        a.shadowRays[i] = made.sun;
        if (a.samples > 1) a.shadowRays[pixels + i] = made.around;
    }
}

}  // namespace cleave::twin
