#include "judge/overlaps.h"

#include "judge/crossings.h"
#include "shared/overlap.h"
#include "shared/query.h"

namespace cleave {

std::vector<uint32_t> bruteOverlaps(const TriangleSet& set, const Box& box) {
    std::vector<uint32_t> met;
    if (!isBox(box)) return met;
    const Box scaled = scaledBox(box, set.exponent);
    for (const uint32_t prim : set.included)
        if (meetsBox(set.triangles[prim], scaled)) met.push_back(prim);
    return met;
}

bool bruteContains(const TriangleSet& set, const vec3& point) {
    if (!isFinite3(point)) return false;
    if (!bruteOverlaps(set, {point, point}).empty()) return true;
    return bruteCrossings(set, {point, 0.0f, containmentDirection(), infinity()}).size() % 2 == 1;
}

}  // namespace cleave
