// Points and boxes around a scene that spans [-1, 1], or as far as `reach`, for the tests of searches.
#pragma once

#include "shared/box.h"
#include "support/small_scenes.h"

namespace cleave::test {

// Around the triangles, far away, on vertices, edges and faces (to a rounding), and some that are none.
inline std::vector<vec3> pointsAt(const std::vector<Triangle>& world, uint32_t seed, uint32_t count, float reach) {
    Random random(seed ^ 0x51ED270Bu);
    std::vector<vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        vec3 p = random.point(-1.5f * reach, 1.5f * reach);
        if (i % 8 == 1) p = p * 1000.0f;
        if (i % 8 == 2) p = glm::round(p * 4.0f) / 4.0f;
        if (i % 8 >= 5 && !world.empty()) {
            const Triangle& t = world[random.below(static_cast<uint32_t>(world.size()))];
            const float u = random.unit(), v = i % 8 == 5 ? 0.0f : random.unit() * (1.0f - u);
            p = i % 8 == 7 ? t.c : t.a + u * (t.b - t.a) + v * (t.c - t.a);
        }
        if (i % 64 == 63) p[static_cast<int>(i / 64 % 3)] = i % 128 == 63 ? std::nanf("") : infinity();
        points.push_back(p);
    }
    return points;
}

// Large and small, flat, points, with faces on vertices, endless; and some that are none.
inline std::vector<Box> boxesAt(const std::vector<Triangle>& world, uint32_t seed, uint32_t count, float reach) {
    Random random(seed ^ 0x2545F491u);
    std::vector<Box> boxes;
    const std::vector<vec3> points = pointsAt(world, seed, 2 * count, reach);
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 p = points[2 * i], q = i % 3 == 0 ? points[2 * i + 1] : p + random.point(0.0f, 0.3f * reach);
        Box box{glm::min(p, q), glm::max(p, q)};
        if (i % 7 == 1) box.hi = box.lo;
        if (i % 7 == 2) box.hi.y = box.lo.y;
        if (i % 7 == 3) box.lo.z = -infinity();
        if (i % 31 == 30) std::swap(box.lo.x, box.hi.x);
        if (i % 31 == 29) box.hi.z = std::nanf("");
        boxes.push_back(box);
    }
    return boxes;
}

}  // namespace cleave::test
