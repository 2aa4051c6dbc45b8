#include "shared/scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cleave {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kDenormal = std::numeric_limits<float>::denorm_min();

// Every third one a denormal.
float anyFinite(std::mt19937& random) {
    for (uint i = 0;; i++) {
        uint bits = static_cast<uint>(random());
        if (random() % 3 == 0) bits &= 0x807FFFFFu;
        const float x = uintBitsToFloat(bits);
        if (std::isfinite(x)) return x;
    }
}

TEST(Scale, binaryExponentIsIlogb) {
    std::mt19937 random(1);
    for (int i = 0; i < 100000; i++) {
        const float x = anyFinite(random);
        if (x == 0.0f) continue;
        ASSERT_EQ(binaryExponent(x), std::ilogb(x)) << x;
    }
    for (int e = -149; e <= 127; e++) {
        EXPECT_EQ(binaryExponent(std::ldexp(1.0f, e)), e);
        EXPECT_EQ(binaryExponent(-std::ldexp(1.0f, e)), e);
    }
    EXPECT_EQ(binaryExponent(kLargest), 127);
    EXPECT_EQ(binaryExponent(0.0f), kZeroExponent);
    EXPECT_EQ(binaryExponent(-0.0f), kZeroExponent);
}

// In double the product is exact; then the rules for what float cannot hold.
float expectedProduct(float x, int n) {
    const double product = std::ldexp(static_cast<double>(x), n);
    if (std::fabs(product) >= 0x1p128) return product > 0.0 ? infinity() : -infinity();
    if (std::fabs(product) < 0x1p-126) return 0.0f;
    return static_cast<float>(product);
}

TEST(Scale, timesPowerOfTwoIsLdexpWithoutDenormals) {
    std::mt19937 random(2);
    int overflows = 0, underflows = 0, normals = 0;
    for (int i = 0; i < 300000; i++) {
        const float x = anyFinite(random);
        const int n = static_cast<int>(random() % 601) - 300;
        const float expected = expectedProduct(x, n);
        (expected == 0.0f ? underflows : std::isinf(expected) ? overflows : normals)++;
        ASSERT_EQ(floatBitsToUint(timesPowerOfTwo(x, n)), floatBitsToUint(expected)) << x << " * 2^" << n;
    }
    EXPECT_GT(overflows, 10000);
    EXPECT_GT(underflows, 10000);
    EXPECT_GT(normals, 10000);
}

TEST(Scale, timesPowerOfTwoAtItsLimits) {
    EXPECT_EQ(timesPowerOfTwo(1.0f, 127), 0x1p127f);
    EXPECT_EQ(timesPowerOfTwo(1.0f, 128), infinity());
    EXPECT_EQ(timesPowerOfTwo(-1.0f, 128), -infinity());
    EXPECT_EQ(timesPowerOfTwo(1.0f, -126), kSmallestNormal);
    EXPECT_EQ(floatBitsToUint(timesPowerOfTwo(-1.0f, -127)), 0u);
    EXPECT_EQ(floatBitsToUint(timesPowerOfTwo(kDenormal, 0)), 0u) << "a denormal is flushed, whatever n";
    EXPECT_EQ(timesPowerOfTwo(kDenormal, 149), 1.0f);
    EXPECT_EQ(timesPowerOfTwo(-3.0f * kDenormal, 149), -3.0f);
    EXPECT_EQ(timesPowerOfTwo(kLargest, -253), 2.0f * kSmallestNormal * (1.0f - 0x1p-24f));
    EXPECT_EQ(timesPowerOfTwo(kLargest, -254), 0.0f);
}

TEST(Scale, zerosBecomePositiveAndTheRestStays) {
    for (const int n : {-300, -1, 0, 1, 300}) {
        EXPECT_EQ(floatBitsToUint(timesPowerOfTwo(-0.0f, n)), 0u);
        EXPECT_EQ(floatBitsToUint(timesPowerOfTwo(0.0f, n)), 0u);
        EXPECT_EQ(timesPowerOfTwo(infinity(), n), infinity());
        EXPECT_EQ(timesPowerOfTwo(-infinity(), n), -infinity());
        EXPECT_TRUE(std::isnan(timesPowerOfTwo(std::numeric_limits<float>::quiet_NaN(), n)));
    }
}

TEST(Scale, scalesVectorsByComponent) { EXPECT_EQ(timesPowerOfTwo(vec3(1, -2, 3), 4), vec3(16, -32, 48)); }

}  // namespace
}  // namespace cleave
