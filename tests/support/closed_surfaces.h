// Closed surfaces for the tests of the rule "once": every edge belongs to two faces that pass it in opposite
// directions.
#pragma once

#include <cstdlib>
#include <vector>

#include "support/small_scenes.h"

namespace cleave::test {

// An octahedron whose faces are divided n times, oriented outward; place(x, y, z) moves the lattice points with
// |x| + |y| + |z| = n. Where that makes some of them equal, or puts them in line, it stays closed.
template <class Place>
std::vector<Triangle> octasphere(int n, const Place& place) {
    std::vector<Triangle> triangles;
    for (int octant = 0; octant < 8; ++octant) {
        const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
        const auto at = [&](int i, int j) { return place(sx * i, sy * j, sz * (n - i - j)); };
        const auto add = [&](const vec3& a, const vec3& b, const vec3& c) {
            triangles.push_back(sx * sy * sz > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n - i; ++j) {
                add(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
    }
    return triangles;
}

inline vec3 onUnitSphere(int x, int y, int z) {
    const vec3 v(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// On integer coordinates from -side to side: many vertices coincide, many triangles have no area, and rays between
// integer points meet vertices and edges all the time.
inline std::vector<Triangle> latticeBlob(uint32_t seed, int n, int side) {
    Random random(seed);
    // A hash of the point, so that all of its faces place it alike.
    const uint32_t salt = random.below(1u << 30);
    const auto size = static_cast<float>(side);
    return octasphere(n, [&](int x, int y, int z) {
        Random own(salt ^ (static_cast<uint32_t>(x + 64) << 16 | static_cast<uint32_t>(y + 64) << 8 |
                           static_cast<uint32_t>(z + 64)));
        return glm::round(onUnitSphere(x, y, z) * size * own.between(0.4f, 1.0f));
    });
}

// With needles and flat triangles: flattened to a millionth along one axis, and pushed in and out at random.
inline std::vector<Triangle> sliverStar(uint32_t seed, int n) {
    Random random(seed);
    const uint32_t salt = random.below(1u << 30);
    const vec3 size = seed % 2 == 0 ? vec3(1.0f, 1e-3f, 1e-6f) : vec3(1.0f);
    return octasphere(n, [&](int x, int y, int z) {
        Random own(salt ^ (static_cast<uint32_t>(x + 64) << 16 | static_cast<uint32_t>(y + 64) << 8 |
                           static_cast<uint32_t>(z + 64)));
        return onUnitSphere(x, y, z) * size * own.between(0.3f, 1.0f);
    });
}

// A line from outside, 3 times as far away as the surface reaches, through a vertex, a point of an edge or a point of a
// face, as a user's aim would round it.
inline Ray aimedAt(const std::vector<Triangle>& surface, Random& random, float reach) {
    const Triangle& t = surface[random.below(static_cast<uint32_t>(surface.size()))];
    const uint32_t kind = random.below(4);
    const float u = random.unit(), v = random.unit() * (1.0f - u);
    const vec3 target = kind < 2 ? t.a : kind == 2 ? t.a + u * (t.b - t.a) : t.a + u * (t.b - t.a) + v * (t.c - t.a);
    vec3 direction = random.point(-1.0f, 1.0f);
    if (random.below(4) == 0) {
        const Triangle& other = surface[random.below(static_cast<uint32_t>(surface.size()))];
        direction = other.b - target;  // through two vertices, or along an edge
    }
    if (direction == vec3(0.0f)) direction.x = 1.0f;
    const float length = std::sqrt(glm::dot(direction, direction));
    return {target - direction * (3.0f * reach / length), 0.0f, direction, infinity()};
}

}  // namespace cleave::test
