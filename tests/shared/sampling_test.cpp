#include "shared/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "support/chi_square.h"

namespace cleave {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostDeviation = 4.5;  // standard deviations; seeds are fixed, so what passes once always does

float number(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }
vec2 pair(std::mt19937& random) {
    const float x = number(random);
    return {x, number(random)};
}
double lengthOf(const dvec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
// Where a direction is about z, in [0, 1).
double turnOf(double x, double y) {
    const double turn = std::atan2(y, x) / (2.0 * kPi);
    return turn < 0.0 ? turn + 1.0 : turn;
}
// A cell among 16 x 16 of two numbers in [0, 1], which rounding may have put a little beyond.
size_t cellOf(double a, double b) {
    const auto place = [](double x) { return static_cast<size_t>(std::min(std::max(x, 0.0) * 16.0, 15.0)); };
    return 16 * place(a) + place(b);
}
// The integral over the sphere, in equal steps of the height and of the angle about z.
double overSphere(const std::function<double(const vec3&)>& f, double lowest = -1.0, double highest = 1.0) {
    constexpr int kHeights = 1000, kAngles = 64;
    double sum = 0.0;
    for (int i = 0; i < kHeights; i++) {
        const double z = lowest + (highest - lowest) * (i + 0.5) / kHeights, r = std::sqrt(1.0 - z * z);
        for (int j = 0; j < kAngles; j++) {
            const double angle = 2.0 * kPi * (j + 0.5) / kAngles;
            sum += f(vec3(r * std::cos(angle), r * std::sin(angle), z));
        }
    }
    return sum * 2.0 * kPi * (highest - lowest) / (kHeights * kAngles);
}

// All that 24 bits can say.
TEST(Sampling, sineAndCosineAreThoseOfTheAngle) {
    double most = 0.0;
    for (uint i = 0; i < 1u << 24; i++) {
        const float turn = static_cast<float>(i) * 0x1p-24f;
        const SineCosine r = sineCosine(turn);
        const double angle = 2.0 * kPi * turn;
        most = std::max({most, std::fabs(r.sine - std::sin(angle)), std::fabs(r.cosine - std::cos(angle))});
    }
    EXPECT_LT(most, 1e-7);
    EXPECT_EQ(sineCosine(0.0f).sine, 0.0f);
    EXPECT_EQ(sineCosine(0.0f).cosine, 1.0f);
    EXPECT_EQ(sineCosine(0.25f).sine, 1.0f);
    EXPECT_EQ(sineCosine(0.5f).cosine, -1.0f);
    EXPECT_EQ(sineCosine(0.75f).sine, -1.0f);
}

// Squares about the centre go to circles, and along a side of a square the angle grows evenly.
TEST(Sampling, discIsConcentric) {
    EXPECT_EQ(concentricDisc(vec2(0.5f, 0.5f)), vec2(0.0f, 0.0f));
    EXPECT_EQ(concentricDisc(vec2(0.0f, 0.5f)), vec2(-1.0f, 0.0f));
    EXPECT_EQ(concentricDisc(vec2(0.5f, 0.0f)), vec2(0.0f, -1.0f));
    for (int i = 0; i < 64; i++) {
        for (int j = -i; j <= i; j++) {
            const double a = i / 64.0, b = j / 64.0;
            const double x = a * std::cos(kPi / 4.0 * (i == 0 ? 0.0 : b / a));
            const double y = a * std::sin(kPi / 4.0 * (i == 0 ? 0.0 : b / a));
            const auto isAt = [](double u, double v, double atX, double atY) {
                const vec2 p = concentricDisc(vec2(0.5 + 0.5 * u, 0.5 + 0.5 * v));
                EXPECT_NEAR(p.x, atX, 2e-7) << u << " " << v;
                EXPECT_NEAR(p.y, atY, 2e-7) << u << " " << v;
            };
            isAt(a, b, x, y);
            isAt(-a, -b, -x, -y);
            isAt(b, a, y, x);
            isAt(-b, -a, -y, -x);
        }
    }
}

TEST(Sampling, discIsUniform) {
    std::mt19937 random(1);
    std::vector<double> counts(256);
    for (int i = 0; i < 200000; i++) {
        const vec2 p = concentricDisc(pair(random));
        const double x = p.x, y = p.y;
        ASSERT_LE(x * x + y * y, 1.0 + 1e-6);
        counts[cellOf(x * x + y * y, turnOf(x, y))]++;
    }
    EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation) << "seed 1";
}

TEST(Sampling, cosineDirectionsAreDrawnWithTheirDensity) {
    std::mt19937 random(2);
    std::vector<double> counts(256);
    for (int i = 0; i < 200000; i++) {
        const dvec3 d(cosineDirection(pair(random)));
        ASSERT_NEAR(lengthOf(d), 1.0, 1e-6);
        ASSERT_GE(d.z, 0.0);
        counts[cellOf(d.z * d.z, turnOf(d.x, d.y))]++;  // 2 cos d(cos) = d(cos^2)
    }
    EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation) << "seed 2";
    EXPECT_NEAR(overSphere([](const vec3& d) { return cosineDensity(d); }), 1.0, 1e-5);
    EXPECT_NEAR(cosineDensity(vec3(0.0f, 0.0f, 1.0f)), 1.0 / kPi, 1e-7);
    EXPECT_EQ(cosineDensity(vec3(0.0f, 0.0f, -1.0f)), 0.0f);
}

TEST(Sampling, horizonDirectionsAreDrawnWithTheirDensity) {
    std::mt19937 random(6);
    std::vector<double> counts(256);
    for (int i = 0; i < 200000; i++) {
        const dvec3 d(horizonDirection(pair(random)));
        ASSERT_NEAR(lengthOf(d), 1.0, 1e-6);
        ASSERT_GE(d.z, 0.0);
        counts[cellOf(std::sqrt(d.z), turnOf(d.x, d.y))]++;
    }
    EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation) << "seed 6";
    // Midpoints miss a little of its pole at the horizon.
    EXPECT_NEAR(overSphere([](const vec3& d) { return horizonDensity(d); }, 0.0), 1.0, 1e-2);
    for (const double z : {1e-6, 0.25, 1.0})
        EXPECT_NEAR(horizonDensity(vec3(std::sqrt(1.0 - z * z), 0.0, z)) * 4.0 * kPi * std::sqrt(z), 1.0, 1e-6);
}

TEST(Sampling, capHeightKeepsTheDigitsOfSmallAngles) {
    for (const double degrees : {1e-3, 0.2666, 1.0, 30.0, 89.0}) {
        const double half = degrees * kPi / 360.0;
        const double height = 2.0 * std::sin(half) * std::sin(half);
        EXPECT_NEAR(capHeight(static_cast<float>(std::sin(2.0 * half))) / height, 1.0, degrees < 80.0 ? 3e-7 : 1e-4)
            << degrees;
    }
    EXPECT_EQ(capHeight(1.0f), 1.0f);
}

// Of the sun's disc, and of wider ones up to the hemisphere.
TEST(Sampling, coneDirectionsAreDrawnWithTheirDensity) {
    for (const float height : {1.08e-5f, 0.001f, 0.2f, 1.0f}) {
        SCOPED_TRACE(::testing::Message() << "height " << height << ", seed 3");
        std::mt19937 random(3);
        std::vector<double> counts(256);
        for (int i = 0; i < 200000; i++) {
            const vec3 direction = coneDirection(height, pair(random));
            const dvec3 d(direction);
            ASSERT_NEAR(lengthOf(d), 1.0, 1e-6);
            const double square = d.x * d.x + d.y * d.y;
            const double down = d.z > 0.9 ? square / (1.0 + std::sqrt(1.0 - square)) : 1.0 - d.z;
            ASSERT_LE(down, height * (1.0 + 1e-6));
            counts[cellOf(down / height, turnOf(d.x, d.y))]++;
        }
        EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation);
        // Integrated from far below its edge; the edge may be in the midst of a step.
        const double reach = std::min(2.0, 2.0 * height);
        EXPECT_NEAR(overSphere([&](const vec3& d) { return coneDensity(height, d); }, 1.0 - reach, 1.0), 1.0, 2e-3);
    }
    EXPECT_EQ(coneDensity(0.2f, vec3(0.0f, 0.0f, -1.0f)), 0.0f);
    EXPECT_EQ(coneDensity(0.2f, vec3(1.0f, 0.0f, 0.0f)), 0.0f);
}

std::vector<vec3> normals() {
    std::vector<vec3> all;
    for (const float s : {-1.0f, 1.0f}) {
        for (int k = 0; k < 3; k++) {
            vec3 n(0.0f);
            n[k] = s;
            all.push_back(n);
        }
        for (const float small : {1e-30f, 1e-7f, 1e-4f, 1e-2f})
            all.push_back(vec3(small, -small, s * std::sqrt(1.0f - 2.0f * small * small)));
    }
    all.push_back(vec3(0.6f, 0.8f, -0.0f));
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 10000; i++) {
        const dvec3 d(normal(random), normal(random), normal(random));
        all.push_back(vec3(d / lengthOf(d)));
    }
    return all;
}

TEST(Sampling, basesAreOrthonormalAndRightHanded) {
    const auto dot = [](const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    for (const vec3& n : normals()) {
        const Basis b = basisAbout(n);
        const dvec3 x(b.x), y(b.y), z(b.z);
        EXPECT_EQ(b.z, n);
        EXPECT_NEAR(dot(x, x), 1.0, 1e-6) << n.x << " " << n.y << " " << n.z;
        EXPECT_NEAR(dot(y, y), 1.0, 1e-6) << n.x << " " << n.y << " " << n.z;
        EXPECT_NEAR(dot(x, y), 0.0, 1e-6) << n.x << " " << n.y << " " << n.z;
        EXPECT_NEAR(dot(x, z), 0.0, 1e-6) << n.x << " " << n.y << " " << n.z;
        EXPECT_NEAR(dot(y, z), 0.0, 1e-6) << n.x << " " << n.y << " " << n.z;
        EXPECT_NEAR(dot(glm::cross(x, y), z), 1.0, 1e-6) << n.x << " " << n.y << " " << n.z;
    }
}

TEST(Sampling, vectorsGoToTheFrameAndBack) {
    std::mt19937 random(5);
    for (const vec3& n : normals()) {
        const Basis b = basisAbout(n);
        const vec3 v = cosineDirection(pair(random));
        const vec3 back = toLocal(b, toWorld(b, v));
        for (int k = 0; k < 3; k++) {
            EXPECT_NEAR(back[k], v[k], 1e-6);
            EXPECT_NEAR(toWorld(b, vec3(0.0f, 0.0f, 1.0f))[k], n[k], 1e-7);
            EXPECT_NEAR(toWorld(b, vec3(1.0f, 0.0f, 0.0f))[k], b.x[k], 1e-7);
            EXPECT_NEAR(toWorld(b, vec3(0.0f, 1.0f, 0.0f))[k], b.y[k], 1e-7);
        }
    }
}

}  // namespace
}  // namespace cleave
