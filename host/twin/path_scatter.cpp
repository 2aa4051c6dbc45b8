#include "twin/render.h"

namespace cleave::twin {

namespace {

Emitter emitterOf(const PictureArrays& a, TriangleChoice choice) {
    const uint32_t triangle = triangleOf(a.emitters[choice.slot], choice.u);
    const Hit point{0.0f, triangle, choice.at.x, choice.at.y};
    return emitterAt(a.surfaces.arrays(), a.surfaces.parts, point, a.triangles[triangle], hitTriangle(a, point));
}

ChosenLight lightFor(const PictureArrays& a, uint32_t pixel, PassNumbers numbers) {
    ChosenLight light{};
    if (lightChoices(a.settings) == 0) return light;
    const uint32_t index = lightOf(a.settings, pixel, numbers.path, numbers.round);
    light.isSurface = index == a.settings.lightCount;
    if (light.isSurface)
        light.emitter = emitterOf(a, triangleChoice(a.settings, pixel, numbers.path, numbers.round));
    else
        light.source = a.lights[index];
    return light;
}

PathStep stepOf(const PictureArrays& a, uint32_t i, const vec3& throughput, float density, PassNumbers numbers) {
    const Hit& hit = a.hits[i];
    if (hit.prim == kNone) return escape(a.settings, a.rays[i], throughput);
    const uint32_t pixel = pixelOf(i, a.camera.width, a.camera.height);
    const HitSurface point =
        hitSurface(a.surfaces.arrays(), a.surfaces.parts, hit, hitTriangle(a, hit), a.rays[i].direction);
    return scatter(a.settings, {a.albedo.data()}, a.rays[i], hit, a.triangles[hit.prim], point,
                   lightFor(a, pixel, numbers), throughput, density, pixel, numbers.path, numbers.round);
}

}  // namespace

void pathScatter(PictureArrays& a, PassNumbers numbers) {
    const bool first = numbers.round == 0;
    for (uint32_t i = 0; i < a.rays.size(); i++) {
        PathStep s = endOfPath(vec3(0.0f));
        if (first)
            s = stepOf(a, i, vec3(1.0f), 0.0f, numbers);
        else if (!isNoRay(a.rays[i]))
            s = stepOf(a, i, a.throughput[i], a.density[i], numbers);
        if (first && numbers.path == 0) {
            a.radiance[i] = vec3(0.0f);
            a.unlit[i] = vec4(0.0f);
        }
        if (s.unlit)
            a.unlit[i] += vec4(s.found, 1.0f);
        else
            a.radiance[i] += s.found;
        a.direct[i] = s.direct;
        a.shadowRays[i] = s.shadow;
        a.throughput[i] = s.throughput;
        a.density[i] = s.density;
        a.rays[i] = s.next;
    }
}

}  // namespace cleave::twin
