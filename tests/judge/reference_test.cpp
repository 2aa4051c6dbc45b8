// The reference's own arithmetic against integers: coordinates are whole numbers below 2^24, so that 128 bits hold
// every determinant exactly. Scaling an axis by a power of two multiplies all determinants alike and leaves t, so the
// same integers judge floats of very different exponents, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "judge/oracle.h"
#include "judge/reference_triangle.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

using Whole = __int128;
using Vec = std::array<int64_t, 3>;

Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// Differences have 25 bits and their sign, so a determinant stays below 2^78.
Whole determinant(const Vec& a, const Vec& b, const Vec& c) {
    Whole sum = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sum += Whole{a[i]} * (Whole{b[j]} * c[k] - Whole{b[k]} * c[j]);
    }
    return sum;
}

struct IntegerCase {
    Vec o, d, a, b, c;
    Whole edgeA() const { return determinant(d, b - o, c - o); }
    Whole edgeB() const { return determinant(d, c - o, a - o); }
    Whole edgeC() const { return determinant(d, a - o, b - o); }
    Whole height() const { return determinant(a - o, b - o, c - o); }
    Whole slope() const { return edgeA() + edgeB() + edgeC(); }
    bool hits() const {
        const std::array<Whole, 3> e{edgeA(), edgeB(), edgeC()};
        const bool negative = std::any_of(e.begin(), e.end(), [](Whole x) { return x < 0; });
        const bool positive = std::any_of(e.begin(), e.end(), [](Whole x) { return x > 0; });
        return negative != positive;
    }
};

Vec anyVec(test::Random& random, uint32_t bits) {
    const auto component = [&] { return static_cast<int64_t>(random.below(1u << bits)) - (int64_t{1} << (bits - 1)); };
    const int64_t x = component(), y = component();
    return {x, y, component()};
}

// A point of the triangle's plane with whole coordinates: a + i (b - a) + j (c - a) of small edges.
IntegerCase anyCase(test::Random& random, uint32_t kind) {
    IntegerCase k;
    const uint32_t edge = 4 + random.below(12);
    k.a = anyVec(random, 20);
    k.b = k.a - anyVec(random, edge);
    k.c = k.a - anyVec(random, edge);
    k.d = anyVec(random, 8 + random.below(12));
    const Vec& target = kind == 0 ? k.a : kind == 1 ? k.b : k.c;
    if (kind == 3) {  // grazing: the direction is nearly in the plane
        const Vec e1 = k.b - k.a, e2 = k.c - k.a;
        const int64_t i = random.below(31), j = random.below(31);
        for (size_t x = 0; x < 3; ++x) k.d[x] = i * e1[x] + j * e2[x];
        k.d[random.below(3)] += 1;
    }
    const int64_t steps = 1 + random.below(kind == 3 ? 4 : 16);
    for (size_t x = 0; x < 3; ++x) k.o[x] = target[x] - steps * k.d[x] + (kind == 2 ? 1 : 0);
    return k;
}

// Each axis times 2^exponents[axis].
vec3 asFloats(const Vec& v, const std::array<int, 3>& exponents) {
    vec3 f;
    for (size_t x = 0; x < 3; ++x) f[static_cast<int>(x)] = std::ldexp(static_cast<float>(v[x]), exponents[x]);
    return f;
}

bool isFinitePoint(const Vec& v) {
    return std::all_of(v.begin(), v.end(), [](int64_t x) { return std::abs(x) < (1 << 24); });
}

TEST(ReferenceTriangle, EqualsIntegerArithmetic) {
    using Wide = __float128;
    int hits = 0, misses = 0, cancelled = 0;
    for (uint32_t seed = 0; seed < 60000; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const IntegerCase k = anyCase(random, seed % 4);
        if (!isFinitePoint(k.o) || !isFinitePoint(k.d) || !isFinitePoint(k.b) || !isFinitePoint(k.c)) continue;
        if (k.d == Vec{0, 0, 0}) continue;
        std::array<int, 3> exponents{};
        for (int& e : exponents) e = static_cast<int>(random.below(160)) - 80;
        const Triangle t{asFloats(k.a, exponents), asFloats(k.b, exponents), asFloats(k.c, exponents)};
        const Ray ray{asFloats(k.o, exponents), 0.0f, asFloats(k.d, exponents), infinity()};
        const LineHit hit = intersectLine(ray, t);
        ASSERT_EQ(hit.hits, k.hits());
        (hit.hits ? hits : misses)++;
        if (!hit.hits) continue;
        const PreciseT own = preciseT(ray, t);
        const Wide height = static_cast<Wide>(k.height()), slope = static_cast<Wide>(k.slope());
        const Wide allowed = (height < 0 ? -height : height) * 0x1p-98;
        const Wide error = (Wide(own.high) + Wide(own.low)) * slope - height;
        ASSERT_TRUE(error <= allowed && -error <= allowed);
        const double truth = static_cast<double>(height / slope);
        ASSERT_LE(std::fabs(own.high - truth), 0x1p-49 * std::fabs(truth));
        ASSERT_LE(std::fabs(hit.t - truth), 3e-9 * std::fabs(truth));
        // Terms of 2^70 that leave less than 2^24: what plain double would get wrong.
        cancelled += k.slope() < (1 << 24) && k.slope() > -(1 << 24) ? 1 : 0;
    }
    EXPECT_GT(hits, 15000);
    EXPECT_GT(misses, 5000);
    EXPECT_GT(cancelled, 1000);
}

TEST(ReferenceTriangle, KnowsWhatIsNearAnEdge) {
    const Triangle t{{1, 1, 8}, {3, 1, 8}, {1, 3, 8}};  // the largest coordinate of every edge is 8: an ulp is 2^-20
    const auto near = [&](float x, float y, float length) {
        return passesNearEdge({{x, y, 0}, 0.0f, {0, 0, length}, infinity()}, t, 4.0);
    };
    for (const float length : {1.0f, 1e-40f, 3e38f}) {
        SCOPED_TRACE(length);
        EXPECT_TRUE(near(1.0f, 2.0f, length));
        EXPECT_TRUE(near(1.0f, 1.0f - 0x1.8p-19f, length));
        EXPECT_TRUE(near(1.0f + 0x1p-18f, 2.0f, length)) << "4 ulp, inside";
        EXPECT_FALSE(near(1.0f + 0x1.1p-18f, 2.0f, length));
        EXPECT_TRUE(near(2.0f + 0x1p-19f, 2.0f, length)) << "the slanted edge";
        EXPECT_FALSE(near(2.0f + 0x1p-17f, 2.0f, length));
        EXPECT_FALSE(near(1.5f, 1.5f, length));
        EXPECT_FALSE(near(4.0f, 1.0f, length)) << "on the line of an edge, beyond its end";
    }
}

class EdgeJudge : public testing::Test {
  protected:
    const Triangle t{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    const Reference reference{std::vector<Triangle>{t}, std::vector<uint32_t>{0}};
    Ray at(float x) const { return {{x, 0.5f, 0}, 0.0f, {0, 0, 1}, infinity()}; }
};

TEST_F(EdgeJudge, NamesTheFault) {
    using Verdict = Reference::Verdict;
    using Fault = Reference::Fault;
    const Hit hit{1.0f, 0, 0, 0};
    const auto judged = [&](float x, const Hit& answer) {
        const Reference::Judgement j = reference.judge(at(x), answer, Query::closest);
        return std::pair(j.verdict, j.fault);
    };
    EXPECT_EQ(judged(0.25f, hit), std::pair(Verdict::agrees, Fault::none));
    EXPECT_EQ(judged(0.25f, missedHit()), std::pair(Verdict::mismatch, Fault::missed));
    EXPECT_EQ(judged(0.25f, {2.0f, 0, 0, 0}), std::pair(Verdict::mismatch, Fault::wrong));
    EXPECT_EQ(judged(-0.25f, hit), std::pair(Verdict::mismatch, Fault::falseHit));
    // An ulp of the edge's largest coordinate, 1, is 2^-23.
    EXPECT_EQ(judged(0.0f, hit), std::pair(Verdict::agrees, Fault::none));
    EXPECT_EQ(judged(0.0f, missedHit()), std::pair(Verdict::undecided, Fault::missed));
    EXPECT_EQ(judged(-0x1p-22f, hit), std::pair(Verdict::undecided, Fault::falseHit));
    EXPECT_EQ(judged(-0x1p-22f, missedHit()), std::pair(Verdict::agrees, Fault::none));
    EXPECT_EQ(judged(-0x1p-20f, hit), std::pair(Verdict::mismatch, Fault::falseHit));
}
TEST_F(EdgeJudge, MeasuresTheErrorInUlps) {
    const auto ulps = [&](float found) {
        return reference.judge(at(0.25f), {found, 0, 0, 0}, Query::closest).ulpTError;
    };
    EXPECT_EQ(ulps(1.0f), 0.0);
    EXPECT_EQ(ulps(1.0f + 0x1p-23f), 1.0);
    EXPECT_EQ(ulps(1.0f - 0x1p-24f), 0.5);
    EXPECT_EQ(reference.judge(at(0.25f), {1.0f + 0x1p-23f, 0, 0, 0}, Query::closest).relativeTError, 0x1p-23);
}

}  // namespace
}  // namespace cleave
