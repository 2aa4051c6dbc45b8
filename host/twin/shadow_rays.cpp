#include "twin/render.h"

namespace cleave::twin {

std::vector<Ray> shadowRays(const ShadeArrays& a, float offset) {
    std::vector<Ray> rays;
    for (size_t i = 0; i < a.rays.size(); i++) {
        const Hit& hit = a.hits[i];
        rays.push_back(shadowRay(a.rays[i], hit, hit.prim == kNone ? Triangle{} : a.triangles[hit.prim], offset));
    }
    return rays;
}

}  // namespace cleave::twin
