#include <algorithm>

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

PathStep stepOf(const PictureArrays& a, uint32_t i, uint32_t path, const vec3& throughput, float density,
                PassNumbers numbers) {
    const Hit& hit = a.hits[i];
    if (hit.prim == kNone) return escape(a.settings, a.rays[i], throughput);
    const uint32_t pixel = pixelOf(path, a.camera.width, a.camera.height);
    const HitSurface point =
        hitSurface(a.surfaces.arrays(), a.surfaces.parts, hit, hitTriangle(a, hit), a.rays[i].direction);
    return scatter(a.settings, {a.albedo.data()}, a.rays[i], hit, a.triangles[hit.prim], point,
                   lightFor(a, pixel, numbers), throughput, density, pixel, numbers.path, numbers.round);
}

struct PathAfter {
    uint32_t path;
    PathStep step;
};

PathAfter afterStep(PictureArrays& a, uint32_t i, PassNumbers numbers) {
    const bool first = numbers.round == 0;
    const uint32_t path = first ? i : a.paths[i];
    PathStep s = endOfPath(vec3(0.0f));
    if (first)
        s = stepOf(a, i, path, vec3(1.0f), 0.0f, numbers);
    else if (!isNoRay(a.rays[i]))
        s = stepOf(a, i, path, a.throughput[i], a.density[i], numbers);
    if (first && numbers.path == 0) {
        a.radiance[path] = vec3(0.0f);
        a.unlit[path] = vec4(0.0f);
    }
    if (s.unlit)
        a.unlit[path] += vec4(s.found, 1.0f);
    else
        a.radiance[path] += s.found;
    return {path, s};
}

}  // namespace

void pathScatter(PictureArrays& a, PassNumbers numbers) {
    const auto count = static_cast<uint32_t>(a.rays.size());
    for (uint32_t begin = 0; begin < count; begin += kGroup) {
        std::vector<PathAfter> paths;
        for (uint32_t i = begin; i < std::min(begin + kGroup, count); i++) paths.push_back(afterStep(a, i, numbers));
        std::vector<PathAfter> lit = paths;
        std::stable_partition(paths.begin(), paths.end(), [](const PathAfter& p) { return !isNoRay(p.step.next); });
        std::stable_partition(lit.begin(), lit.end(), [](const PathAfter& p) { return !isNoRay(p.step.shadow); });
        for (uint32_t k = 0; k < paths.size(); k++) {
            a.rays[begin + k] = paths[k].step.next;
            a.paths[begin + k] = paths[k].path;
            a.throughput[begin + k] = paths[k].step.throughput;
            a.density[begin + k] = paths[k].step.density;
            a.shadowRays[begin + k] = lit[k].step.shadow;
            a.shadowPaths[begin + k] = lit[k].path;
            a.direct[begin + k] = lit[k].step.direct;
        }
    }
}

}  // namespace cleave::twin
