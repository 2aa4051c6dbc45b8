#include "twin/render.h"

namespace cleave::twin {

namespace {

glm::vec3 colourOf(const ShadeArrays& a, uint32_t view, float low, float high, size_t i) {
    const Hit& hit = a.hits[i];
    const glm::vec3 black(0.0f);
    switch (view) {
        case kViewSteps:
            return scaleColour(onScale(float(a.steps[i].inner + a.steps[i].leaves), low, high));
        case kViewLeaves:
            return hit.prim == kNone ? black : scaleColour(onScale(float(a.steps[i].hitLeaf), low, high));
        case kViewDepth:
            return hit.prim == kNone ? black : glm::vec3(1.0f - 0.9f * onScale(hit.t, low, high));
        default:
            break;
    }
    if (hit.prim == kNone) return view == kViewShaded ? encoded(backgroundColour(a.rays[i].direction)) : black;
    const glm::vec3 normal = facingNormal(a.triangles[hit.prim], a.rays[i].direction);
    if (view == kViewNormals) return normal * 0.5f + 0.5f;
    const glm::vec3 base(a.baseColours[a.materialOf[hit.prim]]);
    return encoded(shadedColour(base, normal, a.shadowHits[i].prim == kNone));
}

}  // namespace

std::vector<uint32_t> shade(const ShadeArrays& a, uint32_t view, float scaleLow, float scaleHigh) {
    std::vector<uint32_t> pixels;
    for (size_t i = 0; i < a.rays.size(); i++)
        pixels.push_back(packedColour(colourOf(a, view, scaleLow, scaleHigh, i)));
    return pixels;
}

}  // namespace cleave::twin
