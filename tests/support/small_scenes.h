// Small scenes and rays for the tests of this folder. A seed fixes everything.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "shared/ray.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave::test {

// Uniform numbers without std::uniform_real_distribution, whose results differ between libraries.
class Random {
  public:
    explicit Random(uint32_t seed) : engine_(seed) {}
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(engine_() % n); }
    float unit() { return static_cast<float>(engine_() >> 8) / 16777216.0f; }
    float between(float lo, float hi) { return lo + (hi - lo) * unit(); }
    vec3 point(float lo, float hi) {
        const float x = between(lo, hi), y = between(lo, hi), z = between(lo, hi);
        return vec3(x, y, z);
    }

  private:
    std::mt19937 engine_;
};

// `count` triangles of about `size` in the unit cube.
inline std::vector<Triangle> soup(uint32_t seed, uint32_t count, float size) {
    Random random(seed);
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 centre = random.point(0.0f, 1.0f);
        const vec3 a = centre + random.point(-size, size);
        const vec3 b = centre + random.point(-size, size);
        triangles.push_back({a, b, centre + random.point(-size, size)});
    }
    return triangles;
}

// Vertices on integer coordinates 0 to `side`: many planar, coplanar, touching and degenerate triangles.
inline std::vector<Triangle> integerSoup(uint32_t seed, uint32_t count, uint32_t side) {
    Random random(seed);
    const auto vertex = [&] {
        const auto x = static_cast<float>(random.below(side + 1));
        const auto y = static_cast<float>(random.below(side + 1));
        const auto z = static_cast<float>(random.below(side + 1));
        return vec3(x, y, z);
    };
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 a = vertex(), b = vertex();
        triangles.push_back({a, b, vertex()});
    }
    return triangles;
}

// A sheet of n x n squares, two triangles each; at(i, j) is a corner, i and j from 0 to n.
template <class Corner>
std::vector<Triangle> sheetOf(uint32_t n, const Corner& at) {
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t j = 0; j < n; ++j) {
            triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return triangles;
}

inline std::vector<Triangle> transformed(std::vector<Triangle> triangles, float factor, vec3 offset) {
    for (Triangle& t : triangles) t = {t.a * factor + offset, t.b * factor + offset, t.c * factor + offset};
    return triangles;
}

// A closed surface with bumps, about 4 side^2 triangles.
inline std::vector<Triangle> bumpySphere(uint32_t side) {
    const auto at = [&](uint32_t i, uint32_t j) {
        const float u = 6.2831853f * static_cast<float>(i % (2 * side)) / static_cast<float>(2 * side);
        const float v = 3.1415927f * static_cast<float>(j) / static_cast<float>(side);
        const float r = 1.0f + 0.2f * std::sin(7.0f * u) * std::sin(5.0f * v);
        return vec3(r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), 0.7f * r * std::cos(v));
    };
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < 2 * side; ++i)
        for (uint32_t j = 0; j < side; ++j) {
            triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return triangles;
}

// Rays at a scene that spans [lo, hi]: from outside to inside and from inside out, some along axes, some in a plane.
inline std::vector<Ray> raysAt(uint32_t seed, uint32_t count, float lo, float hi) {
    Random random(seed ^ 0x9E3779B9u);
    std::vector<Ray> rays;
    const float reach = hi - lo;
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 target = random.point(lo, hi);
        vec3 origin = random.point(lo - reach, hi + reach);
        vec3 direction = target - origin;
        if (i % 4 == 1) {
            direction = vec3(0.0f);
            direction[static_cast<int>(i / 4 % 3)] = i % 8 == 1 ? 1.0f : -1.0f;
            origin = target - direction * reach;
        }
        rays.push_back({origin, 0.0f, direction, infinity()});
    }
    return rays;
}

// Rays whose origins and targets lie on integer coordinates: through edges and vertices, inside planes.
inline std::vector<Ray> integerRays(uint32_t seed, uint32_t count, uint32_t side) {
    Random random(seed ^ 0x7F4A7C15u);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        vec3 ends[2];
        for (vec3& end : ends)
            for (int axis = 0; axis < 3; ++axis) end[axis] = static_cast<float>(random.below(side + 3)) - 1.0f;
        if (rays.size() % 3 == 0) {  // along an axis
            const vec3 from = ends[0];
            ends[1] = from;
            ends[1][static_cast<int>(random.below(3))] += random.below(2) == 0 ? 1.0f : -1.0f;
        }
        if (ends[0] == ends[1]) continue;
        rays.push_back({ends[0], 0.0f, ends[1] - ends[0], infinity()});
    }
    return rays;
}

}  // namespace cleave::test
