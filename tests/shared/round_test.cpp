// Roundings that devices may get wrong, against the host's IEEE arithmetic.
#include "shared/round.h"

#include <gtest/gtest.h>

#include <random>

namespace cleave {
namespace {

double anyDouble(std::mt19937_64& random, int smallest, int largest) {
    const double fraction = std::uniform_real_distribution<double>(1.0, 2.0)(random);
    const int exponent = std::uniform_int_distribution<int>(smallest, largest)(random);
    return std::ldexp(random() % 2 == 0 ? fraction : -fraction, exponent);
}

TEST(CorrectedQuotient, repairsQuotientsThatAreOffByThreeUlp) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 300000; ++i) {
        const bool wide = i % 2 == 0;
        const double a = anyDouble(random, wide ? -590 : -2, wide ? 590 : 2);
        const double b = std::abs(anyDouble(random, wide ? -190 : -2, wide ? 190 : 2));
        for (const bool up : {false, true}) {
            double quotient = a / b;
            for (int ulps = 0; ulps <= 3; ++ulps) {
                ASSERT_EQ(correctedQuotient(a, b, quotient), a / b)
                    << std::hexfloat << a << " / " << b << " from " << quotient;
                quotient = nextDouble(quotient, up);
            }
        }
    }
}

// Steps are half as wide below a power of two; quotients of small numbers are often exact.
TEST(CorrectedQuotient, isRightAroundPowersOfTwoAndWhereItIsExact) {
    for (int a = -64; a <= 64; ++a)
        for (int b = 1; b <= 64; ++b)
            for (const double off : {-0x1p-52, -0x1p-53, 0.0, 0x1p-53, 0x1p-52}) {
                const double from = double(a) + off, by = double(b) - off;
                if (from == 0.0) continue;
                for (const bool up : {false, true})
                    ASSERT_EQ(correctedQuotient(from, by, nextDouble(from / by, up)), from / by)
                        << std::hexfloat << from << " / " << by;
            }
}

TEST(CorrectedQuotient, leavesWhatIsTooLargeOrTooSmallAsItIs) {
    EXPECT_EQ(correctedQuotient(0.0, 3.0, 0.0), 0.0);
    EXPECT_TRUE(std::signbit(correctedQuotient(-0.0, 3.0, -0.0)));
    EXPECT_EQ(correctedQuotient(0x1p700, 2.0, 0x1p699), 0x1p699);
    EXPECT_EQ(correctedQuotient(0x1p-700, 2.0, 0x1p-701), 0x1p-701);
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(correctedQuotient(infinite, 2.0, infinite), infinite);
    EXPECT_TRUE(std::isnan(correctedQuotient(std::nan(""), 2.0, std::nan(""))));
}

TEST(NextDouble, isTheNextOne) {
    std::mt19937_64 random(2);
    const double infinite = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 100000; ++i) {
        const double x =
            i % 8 == 0 ? std::ldexp(i % 16 == 0 ? 1.0 : -1.0, i % 1000 - 500) : anyDouble(random, -1000, 1000);
        ASSERT_EQ(nextDouble(x, true), std::nextafter(x, infinite)) << std::hexfloat << x;
        ASSERT_EQ(nextDouble(x, false), std::nextafter(x, -infinite)) << std::hexfloat << x;
    }
    EXPECT_EQ(nextDouble(doubleOf({0xFFFFFFFFu, 0x3FF00000u}), true), doubleOf({0u, 0x3FF00001u})) << "carries";
    EXPECT_EQ(nextDouble(doubleOf({0u, 0x3FF00001u}), false), doubleOf({0xFFFFFFFFu, 0x3FF00000u})) << "borrows";
}

void expectRounded(double x) {
    ASSERT_EQ(roundedBits(x), floatBitsToUint(static_cast<float>(x))) << std::hexfloat << x;
}

TEST(RoundedBits, areThoseOfTheNearestFloat) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 300000; ++i) {
        expectRounded(anyDouble(random, -160, -120));
        expectRounded(anyDouble(random, -300, 200));
        // Halfway between two floats below the smallest normal one, and beside that.
        const double half = std::ldexp(static_cast<double>(random() % (1u << 23)) + 0.5, -149);
        for (const double x : {half, nextDouble(half, true), nextDouble(half, false), -half}) expectRounded(x);
    }
    for (const double x : {0.0, -0.0, 0x1p-149, 0x1p-150, 0x1.8p-150, -0x1p-1000, 0x1p-126, 0x1.fffffffp-127, 0x1p128,
                           -std::numeric_limits<double>::infinity(), 1e-320})
        expectRounded(x);
    EXPECT_TRUE(isNan(uintBitsToFloat(roundedBits(std::nan("")))));
}

}  // namespace
}  // namespace cleave
