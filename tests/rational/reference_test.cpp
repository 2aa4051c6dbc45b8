#include <gtest/gtest.h>

#include "judge/reference_triangle.h"
#include "rational/rational.h"

namespace cleave {
namespace {

using test::exactly;
using test::Rational;

struct Shot {
    Ray ray;
    Triangle triangle;
};

// At vertices, edges and insides of triangles of all shapes and sizes, from all distances, at times exactly.
Shot anyShot(std::mt19937& random) {
    const float size = std::ldexp(1.0f, static_cast<int>(random() % 80) - 40);
    const auto corner = [&] { return random() % 4 == 0 ? test::anyScales(random, 30) : test::anyPoint(random, 1.0f); };
    Triangle t{corner(), corner(), corner()};
    vec3 d = test::anyPoint(random, 1.0f);
    const float b = std::fabs(test::anyFloat(random, 1.0f)), c = random() % 3 == 0 ? 0.0f : (1.0f - b) * 0.5f;
    vec3 target = random() % 3 == 0 ? t.a : t.a + b * (t.b - t.a) + c * (t.c - t.a);
    if (random() % 2 == 0) {
        t = {test::onGrid(t.a, 3), test::onGrid(t.b, 3), test::onGrid(t.c, 3)};
        d = test::onGrid(d, 2);
        target = test::onGrid(target, 3);
    }
    const vec3 o = target - std::ldexp(1.0f, static_cast<int>(random() % 20)) * d;
    return {{o * size, 0.0f, d, infinity()}, {t.a * size, t.b * size, t.c * size}};
}

TEST(ReferenceTriangle, EqualsRationals) {
    int hits = 0, misses = 0, onEdges = 0, flat = 0;
    for (uint seed = 0; seed < 20000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const Shot shot = anyShot(random);
        if (!isValidRay(shot.ray)) continue;
        const test::RationalCase truth(shot.ray.origin, shot.ray.direction, shot.triangle);
        const LineHit hit = intersectLine(shot.ray, shot.triangle);
        ASSERT_EQ(hit.hits, truth.hits());
        (hit.hits ? hits : misses)++;
        const std::array<Rational, 3> edges = truth.edges();
        flat += edges[0] == 0 && edges[1] == 0 && edges[2] == 0 ? 1 : 0;
        if (!hit.hits) continue;
        onEdges += edges[0] == 0 || edges[1] == 0 || edges[2] == 0 ? 1 : 0;
        const PreciseT own = preciseT(shot.ray, shot.triangle);
        const Rational t = truth.height() / truth.slope(), size = abs(t);
        const Rational error = abs(exactly(own.high) + exactly(own.low) - t);
        ASSERT_LE(error, Rational(size * exactly(0x1p-98)));
        ASSERT_LE(Rational(abs(exactly(own.high) - t)), Rational(size * exactly(0x1p-49)));
        ASSERT_LE(Rational(abs(exactly(hit.t) - t)), Rational(size * exactly(3e-9)));
    }
    EXPECT_GT(hits, 4000);
    EXPECT_GT(misses, 1000);
    EXPECT_GT(onEdges, 1000);
    EXPECT_GT(flat, 20);
}

}  // namespace
}  // namespace cleave
