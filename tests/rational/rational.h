// The truth in rational numbers of any length (GMP), which have no rounding and share nothing with what they judge:
// determinants by Cramer's rule, from the definition.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <random>

#include "shared/ray.h"
#include "shared/triangle.h"

namespace cleave::test {

using Rational = mpq_class;
using RationalVec = std::array<Rational, 3>;

inline Rational exactly(double x) { return Rational(x); }
inline RationalVec exactly(const vec3& v) { return {exactly(v.x), exactly(v.y), exactly(v.z)}; }
inline RationalVec operator-(const RationalVec& v, const RationalVec& w) {
    return {Rational(v[0] - w[0]), Rational(v[1] - w[1]), Rational(v[2] - w[2])};
}
inline Rational determinant(const RationalVec& a, const RationalVec& b, const RationalVec& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// A line and a triangle.
struct RationalCase {
    RationalVec o, d, a, b, c;

    RationalCase(const vec3& origin, const vec3& direction, const Triangle& t)
        : o(exactly(origin)), d(exactly(direction)), a(exactly(t.a)), b(exactly(t.b)), c(exactly(t.c)) {}
    Rational height() const { return determinant(a - o, b - o, c - o); }
    Rational slope() const { return determinant(d, b - a, c - a); }
    // Of the edges opposite of a, b and c.
    std::array<Rational, 3> edges() const {
        return {determinant(d, b - o, c - o), determinant(d, c - o, a - o), determinant(d, a - o, b - o)};
    }
    bool hits() const {
        const std::array<Rational, 3> e = edges();
        const bool negative = std::any_of(e.begin(), e.end(), [](const Rational& x) { return x < 0; });
        const bool positive = std::any_of(e.begin(), e.end(), [](const Rational& x) { return x > 0; });
        return negative != positive;
    }
};

inline float anyFloat(std::mt19937& random, float size) {
    return std::uniform_real_distribution<float>(-size, size)(random);
}
inline vec3 anyPoint(std::mt19937& random, float size) {
    const float x = anyFloat(random, size), y = anyFloat(random, size);
    return {x, y, anyFloat(random, size)};
}
// Coordinates from 1 down to 2^-`bits`, each of a size of its own.
inline vec3 anyScales(std::mt19937& random, uint bits) {
    vec3 v = anyPoint(random, 1.0f);
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::ldexp(v[axis], -static_cast<int>(random() % (bits + 1)));
    return v;
}
// Rounded to few bits, so that points coincide and planes are met exactly.
inline vec3 onGrid(vec3 v, int bits) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::ldexp(std::round(std::ldexp(v[axis], bits)), -bits);
    return v;
}

}  // namespace cleave::test
