#include <limits>

#include "stability/cases.h"
#include "stability/shapes.h"

namespace cleave {
namespace {

using Triangles = std::vector<Triangle>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

Triangles empty(Random&, bool) { return {}; }
Triangles one(Random&, bool) { return {{{0, 0, 0}, {1, 0, 0.25f}, {0, 1, 0.5f}}}; }
Triangles two(Random&, bool) { return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}; }
Triangles three(Random&, bool) {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}};
}
Triangles four(Random&, bool) {
    const vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}
Triangles identical(Random&, bool) { return Triangles(500, {{0, 0, 0}, {1, 0.25f, 0}, {0.5f, 1, 0.125f}}); }

// Points, segments, three vertices on a line that no axis is parallel to.
Triangles degenerate(Random& random, bool) {
    Triangles triangles;
    for (uint32_t i = 0; i < 100; ++i) {
        const vec3 p = glm::round(random.inBox(dvec3(0.0), dvec3(8.0))),
                   q = glm::round(random.inBox(dvec3(0), dvec3(8)));
        triangles.push_back({p, i % 3 == 0 ? p : q, i % 2 == 0 ? p : p + 2.0f * (q - p)});
    }
    return triangles;
}
Triangles withBadOnes(Random& random, float bad) {
    Triangles triangles = looseTriangles(random, 200, 0.2);
    triangles[17].b.y = bad;
    triangles[100].a = vec3(-bad, 0.0f, bad);
    triangles[199].c.x = bad;
    return triangles;
}
Triangles nanAmongGood(Random& random, bool) { return withBadOnes(random, kNan); }
Triangles infiniteAmongGood(Random& random, bool) { return withBadOnes(random, kInfinite); }
Triangles degenerateAmongGood(Random& random, bool quick) {
    Triangles triangles = looseTriangles(random, 200, 0.2);
    append(triangles, degenerate(random, quick));
    return triangles;
}

// Zeros of both signs in the very planes that the tree will split at.
Triangles signedZeros(Random& random, bool) {
    Triangles triangles;
    const auto zero = [&] { return random.sign() > 0.0 ? 0.0f : -0.0f; };
    for (uint32_t i = 0; i < 120; ++i) {
        Triangle t{vec3(random.direction()), vec3(random.direction()), vec3(random.direction())};
        const int axis = static_cast<int>(i % 3);
        t.a[axis] = zero();
        if (i % 2 == 0) t.b[axis] = zero();
        if (i % 4 == 0) t.c[axis] = zero();
        triangles.push_back(t);
    }
    return triangles;
}

constexpr StabilityCase kCases[] = {
    {"empty", "no triangle", empty},
    {"one", "one triangle", one},
    {"two", "a square in an axis plane", two},
    {"three", "three sides of a corner at the origin", three},
    {"four", "a tetrahedron", four},
    {"identical", "500 times the same triangle", identical},
    {"degenerate", "nothing but points and lines", degenerate},
    {"nan", "three triangles with a NaN among 197 good ones", nanAmongGood},
    {"infinite", "three infinite triangles among 197 good ones", infiniteAmongGood},
    {"degenerate-among", "points and lines among 200 good triangles", degenerateAmongGood},
    {"signed-zeros", "coordinates of +0 and -0 in all three planes", signedZeros},
};

}  // namespace

std::span<const StabilityCase> tinyCases() { return kCases; }

}  // namespace cleave
