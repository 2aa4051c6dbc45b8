#include "scene/sides.h"

#include <algorithm>
#include <cmath>

namespace cleave {

uint32_t sidesOf(std::span<const Triangle> placed, bool mirrored) {
    glm::dvec3 lo(std::numeric_limits<double>::infinity()), hi(-lo);
    for (const Triangle& t : placed)
        for (const vec3& v : {t.a, t.b, t.c}) {
            lo = glm::min(lo, glm::dvec3(v));
            hi = glm::max(hi, glm::dvec3(v));
        }
    const glm::dvec3 middle = 0.5 * (lo + hi);
    const double size = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z});
    double volume = 0.0;  // six times, in units of size^3
    for (const Triangle& t : placed) {
        const glm::dvec3 a = (glm::dvec3(t.a) - middle) / size;
        const glm::dvec3 b = (glm::dvec3(t.b) - middle) / size;
        const glm::dvec3 c = (glm::dvec3(t.c) - middle) / size;
        volume += glm::dot(a, glm::cross(b, c));
    }
    constexpr double kLeast = 1e-5;
    const bool isTurnedIn = (mirrored ? volume : -volume) > kLeast;  // false where it is not a number
    return (mirrored ? kMirrored : 0u) | (isTurnedIn ? kNoBack : 0u);
}

}  // namespace cleave
