// Rays that start in a triangle's plane, or so close to it that double arithmetic does not know on which side. The
// truth is known by construction: planes with whole coordinates, through points with whole coordinates.
#include "shared/exact_height.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "shared/triangle.h"

namespace cleave {
namespace {

using Vec = std::array<int, 3>;
using Whole = __int128;

int anyWhole(std::mt19937& random, int most) { return std::uniform_int_distribution<int>(-most, most)(random); }
Vec anyVec(std::mt19937& random, int most) {
    const int x = anyWhole(random, most), y = anyWhole(random, most);
    return {x, y, anyWhole(random, most)};
}
Vec along(const Vec& a, int i, const Vec& e, int j, const Vec& f) {
    Vec v{};
    for (size_t k = 0; k < 3; ++k) v[k] = a[k] + i * e[k] + j * f[k];
    return v;
}
vec3 scaled(const Vec& v, int bits) {
    const auto at = [&](size_t k) { return std::ldexp(static_cast<float>(v[k]), -bits); };
    return {at(0), at(1), at(2)};
}
Whole slopeOf(const Vec& d, const Vec& e, const Vec& f) {
    Whole sum = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sum += Whole{d[i]} * (Whole{e[j]} * f[k] - Whole{e[k]} * f[j]);
    }
    return sum;
}

TEST(ExactHeight, RaysFromATriangleHitItAtZero) {
    constexpr int kParts = 61, kBits = 24;
    int hits = 0;
    for (uint seed = 0; seed < 100000; ++seed) {
        std::mt19937 random(seed);
        const Vec e = anyVec(random, 1 << 16), f = anyVec(random, 1 << 16), a = anyVec(random, 1 << 22);
        const int i = static_cast<int>(1 + random() % (kParts - 2));
        const int j = static_cast<int>(1 + random() % static_cast<uint>(kParts - 1 - i));  // strictly inside
        const Triangle t{scaled(a, kBits), scaled(along(a, kParts, e, 0, f), kBits),
                         scaled(along(a, 0, e, kParts, f), kBits)};
        const Vec way = anyVec(random, 1 << 20);
        if (slopeOf(way, e, f) == 0) continue;
        const Hit h = intersectTriangle(scaled(along(a, i, e, j, f), kBits), scaled(way, 20), t);
        ASSERT_EQ(h.t, 0.0f) << "seed " << seed;
        ++hits;
    }
    EXPECT_GT(hits, 99000);
}

// The plane p x + q y + r z = 0 holds the vertices; the origin has one coordinate of +-2^-k where that of a point of
// the plane is 0, so the sign of its height is that of this coordinate times the plane's.
TEST(ExactHeight, HasTheSignOfTheSmallestDistance) {
    constexpr int kBits = 10;
    int ahead = 0, behind = 0;
    for (uint seed = 0; seed < 100000; ++seed) {
        std::mt19937 random(seed);
        Vec n = anyVec(random, 7);
        for (int& x : n) x = x == 0 ? 3 : x;
        const size_t axis = random() % 3, j = (axis + 1) % 3, k = (axis + 2) % 3;
        // Two ways in the plane: one keeps the axis at 0.
        Vec e{}, f{};
        e[j] = n[k];
        e[k] = -n[j];
        f[axis] = n[j];
        f[j] = -n[axis];
        const int wide = static_cast<int>(8 + random() % 8);
        const Vec a = along({}, -wide, e, -wide, f), b = along({}, 2 * wide + 1, e, -wide, f);
        const Vec c = along({}, -wide, e, 2 * wide + 1, f);
        const Triangle t{scaled(a, kBits), scaled(b, kBits), scaled(c, kBits)};
        vec3 o = scaled(along({}, anyWhole(random, 3), e, 0, f), kBits);
        const bool isUp = random() % 2 == 0;
        o[static_cast<int>(axis)] = std::ldexp(isUp ? 1.0f : -1.0f, -static_cast<int>(20 + random() % 106));
        Vec way = anyVec(random, 1 << 10);
        const Whole rise = Whole{way[0]} * n[0] + Whole{way[1]} * n[1] + Whole{way[2]} * n[2];
        if (rise == 0) continue;
        const bool isAbove = (n[axis] > 0) == isUp;
        const Hit h = intersectTriangle(o, scaled(way, kBits), t);
        if (h.t == infinity()) continue;  // grazing, so that it leaves the triangle's side
        const bool isAhead = isAbove == (rise < 0);
        ASSERT_TRUE(isAhead ? h.t > 0.0f : h.t < 0.0f) << "seed " << seed << ", t " << h.t;
        (isAhead ? ahead : behind)++;
        // |t| = |n_axis o_axis| / |rise|: below what double knows, to a rounding of float as anywhere else.
        const double truth = std::fabs(double(n[axis]) * double(o[static_cast<int>(axis)])) /
                             std::fabs(std::ldexp(static_cast<double>(rise), -kBits));
        if (truth < 0x1p-64 && truth >= 0x1p-126) {
            ASSERT_NEAR(std::fabs(h.t) / truth, 1.0, 0x1p-23) << "seed " << seed;
        }
    }
    EXPECT_GT(ahead, 40000);
    EXPECT_GT(behind, 40000);
}

}  // namespace
}  // namespace cleave
