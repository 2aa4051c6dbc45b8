#include "twin/render.h"

namespace cleave::twin {

namespace {

PathStep stepOf(const PictureArrays& a, uint32_t i, const vec3& throughput, PassNumbers numbers) {
    const Hit& hit = a.hits[i];
    if (hit.prim == kNone) return escape(a.settings, a.rays[i], throughput);
    const uint32_t pixel = pixelOf(i, a.camera.width, a.camera.height);
    LightSource light{};
    if (a.settings.lightCount > 0) light = a.lights[lightOf(a.settings, pixel, numbers.path, numbers.round)];
    const HitSurface point =
        hitSurface(a.surfaces.arrays(), a.surfaces.parts, hit, hitTriangle(a, hit), a.rays[i].direction);
    return scatter(a.settings, {a.albedo.data()}, a.rays[i], hit, a.triangles[hit.prim], point, light, throughput,
                   pixel, numbers.path, numbers.round);
}

}  // namespace

void pathScatter(PictureArrays& a, PassNumbers numbers) {
    const bool first = numbers.round == 0;
    for (uint32_t i = 0; i < a.rays.size(); i++) {
        PathStep s = endOfPath(vec3(0.0f));
        if (first || !isNoRay(a.rays[i])) s = stepOf(a, i, first ? vec3(1.0f) : a.throughput[i], numbers);
        a.radiance[i] = (first && numbers.path == 0 ? vec3(0.0f) : a.radiance[i]) + s.found;
        a.direct[i] = s.direct;
        a.shadowRays[i] = s.shadow;
        a.throughput[i] = s.throughput;
        a.rays[i] = s.next;
    }
}

}  // namespace cleave::twin
