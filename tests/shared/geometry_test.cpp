#include "shared/geometry.h"

#include <gtest/gtest.h>

#include <random>

#include "tree/exact_sum.h"

namespace cleave {
namespace {

// The same sum of products, exactly, by an expansion that grows as it must.
bool hasNoAreaExactly(vec3 a, vec3 b, vec3 c, int i, int j) {
    ExactSum sum;
    const double ax = a[i], ay = a[j], bx = b[i], by = b[j], cx = c[i], cy = c[j];
    for (const double product : {bx * cy, -(bx * ay), -(ax * cy), -(by * cx), by * ax, ay * cx}) sum.add(product);
    return sum.sign() == 0;
}

bool liesOnALineExactly(const Triangle& t) {
    return hasNoAreaExactly(t.a, t.b, t.c, 0, 1) && hasNoAreaExactly(t.a, t.b, t.c, 1, 2) &&
           hasNoAreaExactly(t.a, t.b, t.c, 2, 0);
}

// Triangles on a line whose points are floats, and the same with one vertex a unit in the last place off.
TEST(Geometry, AreaIsDecidedAsByAnExactSum) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    std::uniform_int_distribution<int> exponent(-60, 0), step(-3, 3);
    int onLine = 0, offLine = 0;
    for (int k = 0; k < 200'000; k++) {
        Triangle t;
        const float scale = std::ldexp(1.0f, exponent(random));
        t.a = {unit(random), unit(random), k % 3 == 0 ? 0.0f : unit(random) * scale};
        const vec3 d{std::round(unit(random) * 8) * scale, std::round(unit(random) * 8) * scale,
                     k % 2 == 0 ? 0.0f : std::round(unit(random) * 8) * scale};
        t.a = vec3(std::round(t.a.x * 64) * scale, std::round(t.a.y * 64) * scale, std::round(t.a.z * 64) * scale);
        t.b = t.a + d * static_cast<float>(step(random));
        t.c = t.a + d * static_cast<float>(step(random));
        if (k % 4 == 1) t.c.x = std::nextafter(t.c.x, 1.0f);
        if (k % 4 == 2) t.b = {unit(random), unit(random), unit(random)};
        ASSERT_EQ(liesOnALine(t), liesOnALineExactly(t)) << "triangle " << k;
        (liesOnALine(t) ? onLine : offLine)++;
    }
    EXPECT_GT(onLine, 50'000);
    EXPECT_GT(offLine, 50'000);
}

TEST(Geometry, AffineMapsRoundOnce) {
    const vec3 p{0.1f, 0.2f, 0.3f};
    EXPECT_EQ(transformedBy(2.0f, 3.0f, 5.0f, 7.0f, p),
              double{0.1f} * 2.0 + double{0.2f} * 3.0 + double{0.3f} * 5.0 + 7.0);
}

TEST(Geometry, ReachIsOfFiniteVerticesOnly) {
    EXPECT_EQ(uintBitsToFloat(reachOf({1.0f, -9.0f, 2.0f})), 9.0f);
    EXPECT_EQ(reachOf({1.0f, std::nanf(""), 2.0f}), 0u);
    EXPECT_EQ(reachOf({1.0f, infinity(), 2.0f}), 0u);
}

}  // namespace
}  // namespace cleave
