#include "shared/ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "judge/oracle.h"

namespace cleave {
namespace {

const Ray kGood{{1, 2, 3}, 0.0f, {0, 0, -1}, 5.0f};

TEST(Ray, isValidUnlessItsTextSaysOtherwise) {
    EXPECT_TRUE(isValidRay(kGood));
    Ray r = kGood;
    r.tMax = infinity();
    EXPECT_TRUE(isValidRay(r));
    r = kGood;
    r.tMin = r.tMax;
    EXPECT_TRUE(isValidRay(r)) << "one point";
    r.tMin = nextFloat(r.tMax, true);
    EXPECT_FALSE(isValidRay(r)) << "ends before it begins";
    r = kGood;
    r.tMin = -0.0f;
    EXPECT_TRUE(isValidRay(r));
    r.tMin = -kSmallestNormal;
    EXPECT_FALSE(isValidRay(r)) << "begins behind its origin";
    r = kGood;
    r.tMin = r.tMax = infinity();
    EXPECT_FALSE(isValidRay(r)) << "begins nowhere";
}

TEST(Ray, isInvalidIfAnyPartIsNotANumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {nan, -nan, infinity(), -infinity()}) {
        for (int k = 0; k < 3; k++) {
            Ray r = kGood;
            r.origin[k] = bad;
            EXPECT_FALSE(isValidRay(r)) << k << " " << bad;
            r = kGood;
            r.direction[k] = bad;
            EXPECT_FALSE(isValidRay(r)) << k << " " << bad;
        }
        Ray r = kGood;
        r.tMin = bad;
        EXPECT_FALSE(isValidRay(r)) << bad;
    }
    Ray r = kGood;
    r.tMax = nan;
    EXPECT_FALSE(isValidRay(r));
    r.tMax = -infinity();
    EXPECT_FALSE(isValidRay(r));
}

TEST(Ray, needsADirection) {
    Ray r = kGood;
    r.direction = vec3(0.0f);
    EXPECT_FALSE(isValidRay(r));
    r.direction = vec3(-0.0f, 0.0f, -0.0f);
    EXPECT_FALSE(isValidRay(r));
    for (int k = 0; k < 3; k++) {
        r.direction = vec3(0.0f);
        r.direction[k] = std::numeric_limits<float>::denorm_min();
        EXPECT_TRUE(isValidRay(r)) << "the shortest there is, axis " << k;
        r.direction[k] = -std::numeric_limits<float>::max();
        EXPECT_TRUE(isValidRay(r)) << "the longest there is, axis " << k;
    }
}

// A random mantissa and sign, times a power of two; now and then a zero.
float anyFloat(std::mt19937& random, int lowest, int highest) {
    if (random() % 6 == 0) return random() % 2 == 0 ? 0.0f : -0.0f;
    const int e = lowest + static_cast<int>(random() % static_cast<uint>(highest - lowest + 1));
    const float m = 1.0f + std::ldexp(static_cast<float>(random() >> 9), -23);
    return std::ldexp(random() % 2 == 0 ? m : -m, e);
}

Ray anyRay(std::mt19937& random) {
    Ray r = kGood;
    const int size = static_cast<int>(random() % 81) - 40;
    for (int k = 0; k < 3; k++) {
        r.origin[k] = anyFloat(random, -30, 30);
        r.direction[k] = anyFloat(random, size - 10, size);
    }
    r.tMin = std::fabs(anyFloat(random, -15, 0));
    r.tMax = r.tMin + std::fabs(anyFloat(random, -15, 15));
    return r;
}

// A product of two floats is exact in long double.
long double product(float t, float d) { return static_cast<long double>(t) * static_cast<long double>(d); }

TEST(Ray, scalingIsExact) {
    std::mt19937 random(1);
    int valid = 0;
    for (int i = 0; i < 100000; i++) {
        const Ray r = anyRay(random);
        if (!isValidRay(r)) continue;
        valid++;
        const int exponent = static_cast<int>(random() % 81) - 40;
        const ScaledRay s = scaledRay(r, exponent);
        float largest = 0.0f;
        for (int k = 0; k < 3; k++) {
            ASSERT_EQ(std::ldexp(static_cast<long double>(s.origin[k]), exponent), r.origin[k]);
            ASSERT_EQ(std::ldexp(product(s.tMin, s.direction[k]), exponent), product(r.tMin, r.direction[k]));
            ASSERT_EQ(std::ldexp(product(s.tMax, s.direction[k]), exponent), product(r.tMax, r.direction[k]));
            ASSERT_FALSE(s.origin[k] == 0.0f && std::signbit(s.origin[k]));
            ASSERT_FALSE(s.direction[k] == 0.0f && std::signbit(s.direction[k]));
            largest = max(largest, std::fabs(s.direction[k]));
        }
        ASSERT_GE(largest, 1.0f);
        ASSERT_LT(largest, 2.0f);
        Hit h = missedHit();
        h.t = s.tMax;
        ASSERT_EQ(worldHit(h, s.tExponent).t, r.tMax);
        h.t = s.tMin;
        ASSERT_EQ(worldHit(h, s.tExponent).t, r.tMin);
    }
    EXPECT_GT(valid, 90000);
}

TEST(Ray, scalesExtremeDirections) {
    const float lengths[] = {std::numeric_limits<float>::denorm_min(), kSmallestNormal, 1.0f,
                             std::numeric_limits<float>::max()};
    for (const float length : lengths) {
        Ray r = kGood;
        r.direction = vec3(-length, 0.0f, 0.5f * length);
        const ScaledRay s = scaledRay(r, 7);
        const int e = std::ilogb(length);
        EXPECT_EQ(s.tExponent, 7 - e);
        EXPECT_EQ(s.direction.x, static_cast<float>(-std::ldexp(static_cast<double>(length), -e)));
    }
    Ray r = kGood;
    r.direction = vec3(1e38f, 1e-38f, 0.0f);
    EXPECT_EQ(floatBitsToUint(scaledRay(r, 0).direction.y), 0u) << "too small beside the largest: none";
}

TEST(Ray, keepsEndlessRaysAndMisses) {
    Ray r = kGood;
    r.tMax = infinity();
    EXPECT_EQ(scaledRay(r, -30).tMax, infinity());
    // The last t that has a place among floats when it is brought back.
    const ScaledRay s = scaledRay(r, 30);
    EXPECT_EQ(std::ldexp(double{s.tMax}, s.tExponent), double{std::numeric_limits<float>::max()});
    const Hit miss = worldHit(missedHit(), -30);
    EXPECT_EQ(miss.t, infinity());
    EXPECT_EQ(miss.prim, kNone);
    EXPECT_EQ(miss.u, 0.0f);
    EXPECT_EQ(miss.v, 0.0f);
}

// Of a triangle whose t is beyond the largest float and a nearer one, an any-hit must be the nearer.
// A hit that is kept in world units while a ray waits has the same bits when the ray goes on.
TEST(Ray, hitsReturnFromWorldUnitsUnchanged) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> mantissa(1.0f, 2.0f);
    for (int i = 0; i < 100000; i++) {
        const int exponent = static_cast<int>(random() % 200) - 100;
        const int tExponent = static_cast<int>(random() % 50) - 25;
        const Hit hit{std::ldexp(mantissa(random), exponent), i % 2 == 0 ? 7u : kNone - 1u, 0.25f, 0.5f};
        const Hit world = worldHit(hit, tExponent);
        ASSERT_EQ(world.t, std::ldexp(hit.t, tExponent));
        const Hit back = scaledHit(world, tExponent);
        ASSERT_EQ(std::memcmp(&hit, &back, sizeof(Hit)), 0) << exponent << " " << tExponent;
    }
    EXPECT_EQ(scaledHit(missedHit(), 40).t, infinity());
    EXPECT_EQ(scaledHit(missedHit(), -40).t, infinity());
    // Below the smallest normal number in the world t is lost: traversal must not wait then (lib/restart.glsl).
    EXPECT_EQ(scaledHit(worldHit(Hit{1.0e-30f, 0u, 0.0f, 0.0f}, -40), -40).t, 0.0f);
}

TEST(Ray, anyHitHasAFiniteT) {
    const std::vector<Triangle> triangles = {{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
    const TriangleSet set = makeTriangleSet(triangles);
    const Ray r{{0.25f, 0.25f, 0.0f}, 0.0f, {0.0f, 0.0f, 1e-38f}, infinity()};
    for (const Query query : {Query::closest, Query::any}) {
        const Hit hit = bruteForce(set, r, query);
        EXPECT_EQ(hit.prim, 1u);
        EXPECT_LT(hit.t, infinity());
    }
}

}  // namespace
}  // namespace cleave
