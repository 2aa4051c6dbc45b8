#include "shared/exact_height.h"

#include <gtest/gtest.h>

#include "rational/rational.h"

namespace cleave {
namespace {

using test::exactly;
using test::Rational;

// As they come to traversal: triangles of at most 1, origins of at most 4, nothing below the smallest normal float.
struct Origin {
    vec3 o;
    Triangle t;
};
vec3 flushedPoint(vec3 v) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = flushed(v[axis]);
    return v;
}
// All but a product of three tiny differences cancels: the widest sums that there are.
Origin hiddenOrigin(std::mt19937& random) {
    const auto tiny = [&] { return std::ldexp(1.0f, -static_cast<int>(1 + random() % 126)); };
    const auto side = [&] { return test::anyFloat(random, 1.0f); };
    Origin k{{0.5f, 0.0f, tiny()}, {{0.5f, 0.0f, 0.0f}, {0.5f, tiny(), side()}, {0.5f + 0x1p-24f, side(), side()}}};
    const int turn = static_cast<int>(random() % 3);
    for (vec3* v : {&k.o, &k.t.a, &k.t.b, &k.t.c}) *v = {(*v)[turn], (*v)[(turn + 1) % 3], (*v)[(turn + 2) % 3]};
    return k;
}
Origin anyOrigin(std::mt19937& random) {
    if (random() % 8 == 0) return hiddenOrigin(random);
    const uint bits = random() % 2 == 0 ? 0u : 20u + static_cast<uint>(random() % 106);
    Triangle t{test::anyScales(random, bits), test::anyScales(random, bits), test::anyScales(random, bits)};
    if (random() % 4 == 0) t = {test::onGrid(t.a, 4), test::onGrid(t.b, 4), test::onGrid(t.c, 4)};
    if (random() % 4 == 0) t.c = t.a + 0.5f * (t.b - t.a);  // nearly without an area
    vec3 o = random() % 2 == 0 ? 0.5f * (t.a + t.b) : 0.25f * t.a + 0.5f * t.b + 0.25f * t.c;
    if (random() % 4 == 0) o += test::anyScales(random, 120);
    if (random() % 16 == 0) o = 4.0f * test::anyPoint(random, 1.0f);
    return {flushedPoint(o), {flushedPoint(t.a), flushedPoint(t.b), flushedPoint(t.c)}};
}

TEST(ExactHeight, EqualsRationals) {
    int zeros = 0, tiny = 0;
    for (uint seed = 0; seed < 50000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const Origin k = anyOrigin(random);
        const Rational truth = test::RationalCase(k.o, vec3(1.0f), k.t).height();
        const double own = exactHeight(dvec3(k.o), dvec3(k.t.a), dvec3(k.t.b), dvec3(k.t.c));
        ASSERT_EQ((own > 0.0) - (own < 0.0), sgn(truth));
        const Rational error = abs(exactly(own) - truth), allowed = abs(truth) * exactly(0x1p-51);
        ASSERT_LE(error, allowed);
        zeros += truth == 0 ? 1 : 0;
        tiny += truth != 0 && abs(truth) < exactly(0x1p-150) ? 1 : 0;
    }
    EXPECT_GT(zeros, 1000);
    EXPECT_GT(tiny, 1000);
}

// The bound of the double's error, and with it when the exact sum is needed.
TEST(ExactHeight, SignsOfHitsAreThoseOfRationals) {
    int hits = 0, behind = 0, zeros = 0;
    for (uint seed = 0; seed < 50000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const Origin k = anyOrigin(random);
        const vec3 d = test::anyPoint(random, 1.5f);
        const Hit h = intersectTriangle(k.o, d, k.t);
        if (h.t == infinity()) continue;
        const test::RationalCase truth(k.o, d, k.t);
        const Rational slope = truth.slope();
        // Where double arithmetic does not know which way the ray passes the plane, nothing is said of t's sign.
        const double area =
            largestMagnitude(dvec3(k.t.b) - dvec3(k.t.a)) * largestMagnitude(dvec3(k.t.c) - dvec3(k.t.a));
        if (abs(slope) < exactly(0x1p-44 * area)) continue;
        ++hits;
        const int sign = sgn(truth.height()) * sgn(slope);
        behind += sign < 0 ? 1 : 0;
        zeros += sign == 0 ? 1 : 0;
        ASSERT_EQ(h.t < 0.0f, sign < 0) << h.t;
        ASSERT_TRUE(sign != 0 || h.t == 0.0f) << h.t;
    }
    EXPECT_GT(hits, 10000);
    EXPECT_GT(behind, 1000);
    EXPECT_GT(zeros, 100);
}

}  // namespace
}  // namespace cleave
