#include "twin/render.h"

namespace cleave::twin {

namespace {

bool showsUnlit(const PictureArrays& a, const Hit& hit) {
    return hit.prim != kNone && (materialOf(a.surfaces.arrays(), hit.prim).flags & kMaterialUnlit) != 0;
}

glm::vec3 colourOf(const PictureArrays& a, size_t i) {
    const Hit& hit = a.hits[i];
    const glm::vec3 black(0.0f);
    const ViewScale scale = viewScale(a.state.lowBits, a.state.highBits);
    const auto place = [&](float x) { return onScale(x, scale.low, scale.high); };
    switch (a.view) {
        case kViewSteps:
            return scaleColour(place(static_cast<float>(a.steps[i].inner + a.steps[i].leaves)));
        case kViewLeaves:
            return hit.prim == kNone ? black : scaleColour(place(static_cast<float>(a.steps[i].hitLeaf)));
        case kViewDepth:
            return hit.prim == kNone ? black : glm::vec3(1.0f - 0.9f * place(hit.t));
        default:
            break;
    }
    if (hit.prim == kNone) return a.view == kViewShaded ? backgroundColour(a.rays[i].direction) : black;
    const glm::vec3& direction = a.rays[i].direction;
    if (a.view == kViewNormals) return facingNormal(hitTriangle(a, hit), direction) * 0.5f + 0.5f;
    const HitSurface point = hitSurface(a.surfaces.arrays(), a.surfaces.parts, hit, hitTriangle(a, hit), direction);
    const bool open = a.samples == 1 || a.shadowHits[a.rays.size() + i].prim == kNone;
    return shadedColour(point, a.shadowRays[i].direction, a.shadowHits[i].prim == kNone, open);
}

}  // namespace

void shade(PictureArrays& a, PassNumbers numbers) {
    if (a.state.primary.unfinishedRays + a.state.shadow.unfinishedRays > 0) return;
    if (numbers.path == 0) {
        a.radiance.assign(a.radiance.size(), vec3(0.0f));
        a.unlit.assign(a.unlit.size(), vec4(0.0f));
    }
    for (size_t i = 0; i < a.rays.size(); i++) {
        if (isOfLight(a.view) && showsUnlit(a, a.hits[i]))
            a.unlit[i] += vec4(colourOf(a, i), 1.0f);
        else
            a.radiance[i] += colourOf(a, i);
    }
}

}  // namespace cleave::twin
