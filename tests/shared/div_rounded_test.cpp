#include "shared/div_rounded.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cleave {
namespace {

struct Fraction {
    float a;
    float b;
};

float mantissa(std::mt19937& random) {
    // Mantissas that are all zeros or all ones but for a few bits lie next to where roundings change.
    const uint bits = static_cast<uint>(random()) & 0x7FFFFFu;
    const uint few = static_cast<uint>(random() % 8);
    const uint kind = static_cast<uint>(random() % 4);
    return uintBitsToFloat(0x3F800000u | (kind == 0 ? few : kind == 1 ? 0x7FFFFFu - few : bits));
}

// 0 <= a <= b, 2^-60 < b, quotients from 1 down to about 2^-40.
Fraction anyFraction(std::mt19937& random) {
    const int exponent = static_cast<int>(random() % 90) - 59;
    const int less = random() % 2 == 0 ? static_cast<int>(random() % 3) : static_cast<int>(random() % 40);
    const float a = std::ldexp(mantissa(random), exponent - less);
    const float b = std::ldexp(mantissa(random), exponent);
    return a <= b ? Fraction{a, b} : Fraction{b, a};
}

TEST(DivRounded, isIeeeDivision) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000000; i++) {
        const auto [a, b] = anyFraction(random);
        ASSERT_EQ(correctedQuotient(a, b, a / b), a / b) << std::hexfloat << a << " / " << b;
    }
    EXPECT_EQ(divRounded(0.0f, 3.0f), 0.0f);
    EXPECT_EQ(divRounded(3.0f, 3.0f), 1.0f);
    EXPECT_EQ(divRounded(1.0f, 3.0f), 1.0f / 3.0f);
}

// The host takes a short cut where it may; devices do not. Down to the smallest numbers both give the same bits.
TEST(DivRounded, isTheSameOnTheHostAsOnDevices) {
    std::mt19937 random(4);
    for (int i = 0; i < 1000000; i++) {
        const auto [a, b] = anyFraction(random);
        const int down = i % 100;
        const float smallA = std::ldexp(a, -down), smallB = std::ldexp(b, i % 2 == 0 ? -down : 0);
        if (smallB < kSmallestNormal) continue;
        ASSERT_EQ(divRounded(smallA, smallB), correctedQuotient(smallA, smallB, smallA / smallB))
            << std::hexfloat << smallA << " / " << smallB;
    }
}

TEST(DivRounded, repairsQuotientsThatAreOffByThreeUlp) {
    std::mt19937 random(2);
    for (int i = 0; i < 200000; i++) {
        const auto [a, b] = anyFraction(random);
        for (const bool up : {false, true}) {
            float quotient = a / b;
            for (int ulps = 0; ulps <= 3; ulps++) {
                ASSERT_EQ(correctedQuotient(a, b, quotient), a / b)
                    << std::hexfloat << a << " / " << b << " from " << quotient;
                quotient = nextFloat(quotient, up);
            }
        }
    }
}

// With 24 bits each, a - q b is a multiple of the product of the last places and small: double holds it.
TEST(DivRounded, residualHasTheRightSignAndSize) {
    std::mt19937 random(3);
    for (int i = 0; i < 200000; i++) {
        const auto [a, b] = anyFraction(random);
        const float q = nextFloat(a / b, random() % 2 == 0);
        const double exact = static_cast<double>(a) - static_cast<double>(q) * static_cast<double>(b);
        const double residual = divisionResidual(a, b, q);
        ASSERT_NEAR(residual, exact, 0x1p-22 * std::fabs(exact)) << std::hexfloat << a << " " << b << " " << q;
    }
}

}  // namespace
}  // namespace cleave
