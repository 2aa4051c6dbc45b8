#include "tree/triangle_set.h"

#include <numeric>

#include "shared/geometry.h"

namespace cleave {

TriangleSet makeTriangleSet(std::span<const Triangle> world, std::span<const uint32_t> list) {
    std::vector<uint32_t> all;
    if (list.empty()) {
        all.resize(world.size());
        std::iota(all.begin(), all.end(), 0u);
        list = all;
    }
    uint32_t largest = 0;
    for (const uint32_t i : list)
        for (const vec3& v : {world[i].a, world[i].b, world[i].c}) largest = std::max(largest, reachOf(v));
    TriangleSet set;
    set.exponent = sceneExponent(largest);
    set.triangles.assign(world.size(), Triangle{vec3(0.0f), vec3(0.0f), vec3(0.0f)});
    for (const uint32_t i : list) {
        if (!isFiniteTriangle(world[i])) {
            ++set.nonFinite;
            continue;
        }
        const Triangle t = scaledTriangle(world[i], -set.exponent);
        if (liesOnALine(t)) {
            ++set.noArea;
            continue;
        }
        set.included.push_back(i);
        set.triangles[i] = t;
        set.bounds = including(including(including(set.bounds, t.a), t.b), t.c);
    }
    return set;
}

std::vector<Triangle> trianglesOf(std::span<const Triangle> world, std::span<const uint32_t> list) {
    std::vector<Triangle> listed;
    listed.reserve(list.size());
    for (const uint32_t number : list) listed.push_back(world[number]);
    return listed;
}

}  // namespace cleave
