#include "tree/triangle_set.h"

#include <algorithm>

#include "shared/ray.h"
#include "shared/scale.h"
#include "tree/exact_sum.h"

namespace cleave {
namespace {

// Is the component of (b - a) x (c - a) along the axis that completes (i, j) exactly zero? Double decides nearly
// always, with the error bound of Shewchuk's ORIENT2D; otherwise the six products, each exact in double, are summed
// exactly.
bool hasNoProjectedArea(const Triangle& t, int i, int j) {
    const double ax = t.a[i], ay = t.a[j], bx = t.b[i], by = t.b[j], cx = t.c[i], cy = t.c[j];
    const double left = (bx - ax) * (cy - ay);
    const double right = (by - ay) * (cx - ax);
    constexpr double kBound = 3.4e-16;  // (3 + 16 u) u with u = 2^-53
    if (std::fabs(left - right) > kBound * (std::fabs(left) + std::fabs(right))) return false;
    ExactSum area;
    for (const double product : {bx * cy, -(bx * ay), -(ax * cy), -(by * cx), by * ax, ay * cx}) area.add(product);
    return area.sign() == 0;
}

bool liesOnALine(const Triangle& t) {
    return hasNoProjectedArea(t, 0, 1) && hasNoProjectedArea(t, 1, 2) && hasNoProjectedArea(t, 2, 0);
}

Triangle scaledTriangle(const Triangle& t, int n) {
    return {timesPowerOfTwo(t.a, n), timesPowerOfTwo(t.b, n), timesPowerOfTwo(t.c, n)};
}

// The power of two above the largest coordinate of these triangles; 0 without any.
int exponentOver(std::span<const Triangle> world, std::span<const uint32_t> numbers) {
    float largest = 0.0f;
    for (const uint32_t i : numbers) {
        const Triangle& t = world[i];
        largest = std::max({largest, largestComponent(t.a), largestComponent(t.b), largestComponent(t.c)});
    }
    return largest == 0.0f ? 0 : 1 + binaryExponent(largest);
}

}  // namespace

TriangleSet makeTriangleSet(std::span<const Triangle> world) {
    TriangleSet set;
    set.triangles.assign(world.size(), Triangle{vec3(0.0f), vec3(0.0f), vec3(0.0f)});
    for (uint32_t i = 0; i < world.size(); ++i) {
        const Triangle& t = world[i];
        if (!isFinite3(t.a) || !isFinite3(t.b) || !isFinite3(t.c))
            ++set.nonFinite;
        else if (liesOnALine(t))
            ++set.noArea;
        else
            set.included.push_back(i);
    }
    // Scaling flushes coordinates that are 2^126 times smaller than the largest, which may flatten a triangle. When the
    // one that set the scale is left out for that, the scale is chosen anew; the list only ever shrinks.
    for (size_t before = set.included.size() + 1; before != set.included.size();) {
        before = set.included.size();
        set.exponent = exponentOver(world, set.included);
        std::erase_if(set.included, [&](uint32_t i) { return liesOnALine(scaledTriangle(world[i], -set.exponent)); });
        set.noArea += before - set.included.size();
    }
    for (const uint32_t i : set.included) {
        const Triangle t = scaledTriangle(world[i], -set.exponent);
        set.triangles[i] = t;
        set.bounds = including(including(including(set.bounds, t.a), t.b), t.c);
    }
    return set;
}

}  // namespace cleave
