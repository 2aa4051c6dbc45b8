#include "shared/exact.h"

#include <gtest/gtest.h>

#include "rational/rational.h"

namespace cleave {
namespace {

using test::exactly;
using test::operator-;
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
        const double own = exactDeterminant(k.t.a, true, k.t.b, k.t.c, true, k.o);
        ASSERT_EQ((own > 0.0) - (own < 0.0), sgn(truth));
        const Rational error = abs(exactly(own) - truth), allowed = abs(truth) * exactly(0x1p-51);
        ASSERT_LE(error, allowed);
        zeros += truth == 0 ? 1 : 0;
        tiny += truth != 0 && abs(truth) < exactly(0x1p-150) ? 1 : 0;
    }
    EXPECT_GT(zeros, 1000);
    EXPECT_GT(tiny, 1000);
}

// Vectors of any size and as nearly dependent as floats have them: whole coordinates of a plane through `o`, each axis
// times a power of two of its own; or coordinates of all sizes, and two vectors alike. Then one coordinate moved by
// anything, or none.
struct Vectors {
    vec3 x, a, b, o;
};
Vectors anyVectors(std::mt19937& random) {
    const auto whole = [&](int most) { return static_cast<int>(random() % static_cast<uint>(2 * most + 1)) - most; };
    const auto point = [&](int most) { return vec3(whole(most), whole(most), whole(most)); };
    const vec3 e = point(99), f = point(99);
    const auto inPlane = [&] {
        const auto i = static_cast<float>(whole(99)), j = static_cast<float>(whole(99));
        return i * e + j * f;
    };
    Vectors v{inPlane(), inPlane(), inPlane(), inPlane()};
    if (random() % 4 == 0) v.o = point(1 << 20);
    const bool areOfAllSizes = random() % 4 == 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int exponent = whole(100);
        for (vec3* w : {&v.x, &v.a, &v.b, &v.o})
            (*w)[axis] =
                areOfAllSizes ? std::ldexp(test::anyFloat(random, 1.0f), whole(126)) : std::ldexp((*w)[axis], exponent);
    }
    if (areOfAllSizes) (random() % 2 == 0 ? v.x : v.b) = v.a;
    vec3* const moved[] = {&v.x, &v.a, &v.b, &v.o};
    float& coordinate = (*moved[random() % 4])[static_cast<int>(random() % 3)];
    if (random() % 4 != 0) coordinate += std::ldexp(test::anyFloat(random, 1.0f), whole(120));
    if (random() % 4 == 0) coordinate = std::nextafter(coordinate, 0.0f);
    for (vec3* w : moved) *w = flushedPoint(*w);
    return v;
}

TEST(ExactDeterminant, EqualsRationalsForFloatsOfAnySize) {
    int zeros = 0, tiny = 0, large = 0;
    for (uint seed = 0; seed < 100000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const Vectors v = anyVectors(random);
        const bool xIsPoint = seed % 2 == 0, bIsPoint = seed % 4 < 2;
        const test::RationalVec o = exactly(v.o), nothing = exactly(vec3(0.0f));
        const Rational truth = test::determinant(exactly(v.x) - (xIsPoint ? o : nothing), exactly(v.a) - o,
                                                 exactly(v.b) - (bIsPoint ? o : nothing));
        const double own = exactDeterminant(v.x, xIsPoint, v.a, v.b, bIsPoint, v.o);
        ASSERT_EQ((own > 0.0) - (own < 0.0), sgn(truth));
        const Rational error = abs(exactly(own) - truth), allowed = abs(truth) * exactly(0x1p-51);
        ASSERT_LE(error, allowed);
        zeros += truth == 0 ? 1 : 0;
        tiny += truth != 0 && abs(truth) < exactly(0x1p-150) ? 1 : 0;
        large += abs(truth) > exactly(0x1p150) ? 1 : 0;
    }
    EXPECT_GT(zeros, 1000);
    EXPECT_GT(tiny, 500);
    EXPECT_GT(large, 1000);
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
