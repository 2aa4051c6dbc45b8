#include "figures/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cleave::test {
namespace {

constexpr double kC1 = 6.5025, kC2 = 58.5225;  // (0.01 * 255)^2 and (0.03 * 255)^2

uint32_t grey(uint32_t value) { return value | value << 8 | value << 16 | 0xFF000000u; }

TEST(RelativeRmse, IsTheRootOfTheMeanSquareOverTheMean) {
    const std::vector<vec3> reference{vec3(1.0f), vec3(3.0f)};
    EXPECT_EQ(relativeRmse(reference, reference), 0.0);
    // One of six values is off by 3; the mean is 2.
    EXPECT_NEAR(relativeRmse(std::vector<vec3>{vec3(1.0f), vec3(3.0f, 6.0f, 3.0f)}, reference),
                std::sqrt(9.0 / 6.0) / 2.0, 1e-12);
    EXPECT_TRUE(std::isinf(relativeRmse(reference, std::vector<vec3>(2, vec3(0.0f)))));
}

TEST(MeanOfParts, HasTheErrorOfItsSpread) {
    // 1 and 3: mean 2, variance 2 of one, 1 of the mean.
    const std::vector<std::vector<vec3>> parts{{vec3(1.0f)}, {vec3(3.0f)}};
    const MeanPicture mean = meanOfParts(parts);
    ASSERT_EQ(mean.radiance.size(), 1u);
    EXPECT_EQ(mean.radiance[0], vec3(2.0f));
    EXPECT_NEAR(mean.error, 0.5, 1e-12);
}

// Parts of which the truth is known: what it says of itself is how far it is off.
TEST(MeanOfParts, ItsErrorIsThatAgainstTheTruth) {
    constexpr uint32_t kSeed = 3, kPixels = 5000, kParts = 8;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> uniform(0.0f, 2.0f);
    std::vector<std::vector<vec3>> parts(kParts, std::vector<vec3>(kPixels));
    for (std::vector<vec3>& part : parts)
        for (vec3& c : part) c = vec3(uniform(random), uniform(random), uniform(random));
    const MeanPicture mean = meanOfParts(parts);
    const double off = relativeRmse(mean.radiance, std::vector<vec3>(kPixels, vec3(1.0f)));
    std::printf("seed %u: off by %.4f, estimated %.4f\n", kSeed, off, mean.error);
    EXPECT_NEAR(off, std::sqrt(1.0 / 3.0 / kParts), 0.005);
    EXPECT_NEAR(mean.error, off, 0.005);
}

TEST(StructuralSimilarity, OfTheSamePictureIsOne) {
    std::vector<uint32_t> picture;
    for (uint32_t i = 0; i < 20 * 15; ++i) picture.push_back(grey(i * 37 % 256));
    EXPECT_NEAR(structuralSimilarity(picture, picture, 20, 15), 1.0, 1e-12);
}

TEST(StructuralSimilarity, OfEvenPicturesComparesTheirMeans) {
    const std::vector<uint32_t> one(13 * 12, grey(100)), other(13 * 12, grey(150));
    EXPECT_NEAR(structuralSimilarity(one, other, 13, 12), (2.0 * 100 * 150 + kC1) / (100.0 * 100 + 150.0 * 150 + kC1),
                1e-9);
}

// A single window, whose middle has the weight 1 / (sum over -5..5 of exp(-k^2 / 4.5))^2 = 0.07076.
TEST(StructuralSimilarity, WeighsTheWindowByAGaussian) {
    std::vector<uint32_t> black(11 * 11, grey(0)), dot = black;
    dot[5 * 11 + 5] = grey(200);
    constexpr double kMiddle = 0.0707622, kMean = kMiddle * 200.0, kVariance = kMiddle * 200.0 * 200.0 - kMean * kMean;
    EXPECT_NEAR(structuralSimilarity(dot, black, 11, 11), kC1 / (kMean * kMean + kC1) * kC2 / (kVariance + kC2), 1e-7);
}

TEST(StructuralSimilarity, OfANegativeIsBelowZero) {
    std::vector<uint32_t> one, negative;
    for (uint32_t i = 0; i < 16 * 16; ++i) {
        const uint32_t value = 100 + (i / 16 / 2 % 2) * 60;
        one.push_back(grey(value));
        negative.push_back(grey(260 - value));
    }
    EXPECT_LT(structuralSimilarity(one, negative, 16, 16), -0.5);
}

// Rec. 709: green weighs most.
TEST(StructuralSimilarity, SeesLuma) {
    const std::vector<uint32_t> green(11 * 11, 0xFF00FF00u), blue(11 * 11, 0xFFFF0000u);
    constexpr double kGreen = 0.7152 * 255, kBlue = 0.0722 * 255;
    EXPECT_NEAR(structuralSimilarity(green, blue, 11, 11),
                (2.0 * kGreen * kBlue + kC1) / (kGreen * kGreen + kBlue * kBlue + kC1), 1e-9);
}

// Black stays black, and 0.2 is below the compression of the curve: 0.2 - 0.04, as sRGB (IEC 61966-2-1) has it.
TEST(ShownPixels, HaveTheToneCurveAndSrgb) {
    const std::vector<uint32_t> shown = shownPixels(std::vector<vec3>{vec3(0.0f), vec3(0.2f)});
    const auto byte = static_cast<uint32_t>(std::lround(255.0 * (1.055 * std::pow(0.16, 1.0 / 2.4) - 0.055)));
    EXPECT_EQ(shown, (std::vector<uint32_t>{grey(0), grey(byte)}));
}

}  // namespace
}  // namespace cleave::test
