#include "shared/language.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cleave {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kDenormal = std::numeric_limits<float>::denorm_min();

// Finite, all exponents alike, denormals included.
float anyFinite(std::mt19937& random) {
    for (;;) {
        const float x = uintBitsToFloat(static_cast<uint>(random()));
        if (std::isfinite(x)) return x;
    }
}

TEST(Language, orderedBitsSortAsFloatsDo) {
    const std::vector<float> ascending = {-kLargest,       -1.5f, -1.0f, -kSmallestNormal,
                                          -kDenormal,      -0.0f, 0.0f,  kDenormal,
                                          kSmallestNormal, 1.0f,  1.5f,  kLargest};
    for (size_t i = 1; i < ascending.size(); i++)
        EXPECT_LT(orderedBits(ascending[i - 1]), orderedBits(ascending[i])) << ascending[i];
    std::mt19937 random(1);
    for (int i = 0; i < 100000; i++) {
        const float a = anyFinite(random);
        const float b = i % 2 == 0 ? anyFinite(random) : std::nextafter(a, infinity());
        if (a == b) continue;
        ASSERT_EQ(a < b, orderedBits(a) < orderedBits(b)) << a << " " << b;
    }
}

// `snapped` and the bounds pass take these two words for "nothing yet": no finite float may have them.
TEST(Language, orderedBitsLeaveTheExtremesFree) {
    EXPECT_GT(orderedBits(-kLargest), 0u);
    EXPECT_LT(orderedBits(kLargest), 0xFFFFFFFFu);
}

TEST(Language, orderedBitsComeBack) {
    std::mt19937 random(2);
    for (int i = 0; i < 100000; i++) {
        const float x = anyFinite(random);
        ASSERT_EQ(floatBitsToUint(fromOrderedBits(orderedBits(x))), floatBitsToUint(x)) << x;
    }
    EXPECT_TRUE(std::signbit(fromOrderedBits(orderedBits(-0.0f))));
    EXPECT_FALSE(std::signbit(fromOrderedBits(orderedBits(0.0f))));
}

TEST(Language, nextFloatIsNextafter) {
    std::mt19937 random(3);
    for (int i = 0; i < 100000; i++) {
        const float x = anyFinite(random);
        if (std::fabs(x) < kSmallestNormal) continue;
        ASSERT_EQ(nextFloat(x, true), std::nextafter(x, infinity())) << x;
        ASSERT_EQ(nextFloat(x, false), std::nextafter(x, -infinity())) << x;
    }
    EXPECT_EQ(nextFloat(1.0f, true), 1.0f + 0x1p-23f);
    EXPECT_EQ(nextFloat(1.0f, false), 1.0f - 0x1p-24f);
    EXPECT_EQ(nextFloat(-1.0f, true), -1.0f + 0x1p-24f);
    EXPECT_EQ(nextFloat(kLargest, true), infinity());
    EXPECT_EQ(nextFloat(-kLargest, false), -infinity());
}

// A denormal could be flushed back to the zero that it was to leave.
TEST(Language, nextFloatLeavesZeroByANormalNumber) {
    for (const float zero : {0.0f, -0.0f}) {
        EXPECT_EQ(nextFloat(zero, true), kSmallestNormal);
        EXPECT_EQ(nextFloat(zero, false), -kSmallestNormal);
    }
}

TEST(Language, classifiesByBits) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float x : {0.0f, -0.0f, kDenormal, -1.0f, kLargest, -kLargest}) {
        EXPECT_TRUE(isFinite(x)) << x;
        EXPECT_FALSE(isNan(x)) << x;
    }
    for (const float x : {infinity(), -infinity()}) {
        EXPECT_FALSE(isFinite(x));
        EXPECT_FALSE(isNan(x));
        EXPECT_TRUE(std::isinf(x));
    }
    // Quiet and signalling, either sign, all of the mantissa or one bit of it.
    for (const uint bits : {floatBitsToUint(nan), 0x7F800001u, 0xFF800001u, 0x7FFFFFFFu, 0xFFC00000u}) {
        EXPECT_FALSE(isFinite(uintBitsToFloat(bits))) << std::hex << bits;
        EXPECT_TRUE(isNan(uintBitsToFloat(bits))) << std::hex << bits;
    }
}

TEST(Language, flushesWhatIsBelowTheSmallestNormal) {
    EXPECT_EQ(kSmallestNormal, std::numeric_limits<float>::min());
    for (const float x : {-0.0f, kDenormal, -kDenormal, uintBitsToFloat(0x007FFFFFu), uintBitsToFloat(0x807FFFFFu)})
        EXPECT_EQ(floatBitsToUint(flushed(x)), 0u) << x;
    for (const float x : {kSmallestNormal, -kSmallestNormal, 1.0f, -kLargest, infinity()}) EXPECT_EQ(flushed(x), x);
}

TEST(Language, findsTheLowestAndTheHighestBit) {
    for (uint b = 0; b < 32; b++) {
        EXPECT_EQ(lowestBit(0xFFFFFFFFu << b), b);
        EXPECT_EQ(highestBit(0xFFFFFFFFu >> (31u - b)), b);
    }
}

}  // namespace
}  // namespace cleave
