#include "twin/render.h"

namespace cleave::twin {

namespace {

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
    return shadedColour(point, a.shadowHits[i].prim == kNone);
}

}  // namespace

void shade(PictureArrays& a, PassNumbers numbers) {
    if (a.state.primary.unfinishedRays + a.state.shadow.unfinishedRays > 0) return;
    for (size_t i = 0; i < a.rays.size(); i++)
        a.radiance[i] = (numbers.path == 0 ? vec3(0.0f) : a.radiance[i]) + colourOf(a, i);
}

}  // namespace cleave::twin
