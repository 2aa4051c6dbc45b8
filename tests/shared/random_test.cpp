#include "shared/random.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "support/chi_square.h"

namespace cleave {
namespace {

constexpr double kMostDeviation = 4.5;  // standard deviations; seeds are fixed, so what passes once always does

// By the definition in the paper, in other words: Python's integers modulo 2^32.
TEST(Random, hashesAsPublished) {
    EXPECT_EQ(pcg3d(uvec3(0u, 0u, 0u)), uvec3(0x9BAFD7C6u, 0xA8E88A6Bu, 0x3F15482Cu));
    EXPECT_EQ(pcg3d(uvec3(1u, 2u, 3u)), uvec3(0xFA9F79A6u, 0x48F2F44Cu, 0x596F5AB1u));
    EXPECT_EQ(pcg3d(uvec3(0xFFFFFFFFu)), uvec3(0xA5F48F40u, 0xA4533E83u, 0x515B8A62u));
}

// Undoes one round of mixing.
void unmix(uvec3& w) {
    w.z -= w.x * w.y;
    w.y -= w.z * w.x;
    w.x -= w.y * w.z;
}

TEST(Random, hashesCanBeUndone) {
    std::mt19937 random(1);
    for (int i = 0; i < 100000; i++) {
        const uvec3 words(static_cast<uint>(random()), static_cast<uint>(random()), static_cast<uint>(random()));
        uvec3 w = pcg3d(words);
        unmix(w);
        for (int k = 0; k < 3; k++) w[k] ^= w[k] >> 16;
        unmix(w);
        for (int k = 0; k < 3; k++) w[k] = (w[k] - 1013904223u) * 0xFEE058C5u;
        ASSERT_EQ(w, words) << "number " << i << " of seed 1";
    }
}

TEST(Random, numbersHave24Bits) {
    EXPECT_EQ(unitFloat(0u), 0.0f);
    EXPECT_EQ(unitFloat(0xFFu), 0.0f);
    EXPECT_EQ(unitFloat(0x100u), 0x1p-24f);
    EXPECT_EQ(unitFloat(0x80000000u), 0.5f);
    EXPECT_EQ(unitFloat(0xFFFFFFFFu), 1.0f - 0x1p-24f);
    EXPECT_EQ(sampleNumber(5u, 6u, 7u), sampleNumbers(5u, 6u, 7u).x);
}

// A walk along one of the three words; the other two stay as they are.
struct Walk {
    uvec3 from;
    int along;
};
const std::vector<Walk>& walks() {
    static const std::vector<Walk> all = [] {
        std::vector<Walk> w;
        for (int along = 0; along < 3; along++) {
            for (const uvec3 from : {uvec3(0u), uvec3(1u, 0u, 0u), uvec3(0u, 1u, 0u), uvec3(0u, 0u, 1u),
                                     uvec3(2073599u, 4095u, 60u), uvec3(0x7FFFFFFFu, 17u, 3u)})
                w.push_back({from, along});
        }
        return w;
    }();
    return all;
}
vec3 numbersAt(const Walk& walk, uint step) {
    uvec3 w = walk.from;
    w[walk.along] += step;
    return sampleNumbers(w.x, w.y, w.z);
}
std::string nameOf(const Walk& w) {
    return "from " + std::to_string(w.from.x) + " " + std::to_string(w.from.y) + " " + std::to_string(w.from.z) +
           " along word " + std::to_string(w.along);
}
size_t cellOf(float x, size_t cells) { return static_cast<size_t>(x * static_cast<float>(cells)); }

TEST(Random, numbersAreUniform) {
    for (const Walk& walk : walks()) {
        for (int lane = 0; lane < 3; lane++) {
            std::vector<double> counts(256);
            for (uint i = 0; i < 65536u; i++) counts[cellOf(numbersAt(walk, i)[lane], 256)]++;
            EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation) << nameOf(walk) << ", lane " << lane;
        }
    }
}

// Pairs that a renderer draws next to each other: of successive pixels, paths and dimensions.
TEST(Random, successiveNumbersAreIndependent) {
    for (const Walk& walk : walks()) {
        for (int lane = 0; lane < 3; lane++) {
            for (const uint apart : {1u, 2u, 3u, 1920u}) {
                std::vector<double> counts(32 * 32);
                for (uint i = 0; i < 65536u; i++)
                    counts[32 * cellOf(numbersAt(walk, i)[lane], 32) + cellOf(numbersAt(walk, i + apart)[lane], 32)]++;
                EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation)
                    << nameOf(walk) << ", lane " << lane << ", " << apart << " apart";
            }
        }
    }
}

TEST(Random, numbersOfOneDecisionAreIndependent) {
    for (const Walk& walk : walks()) {
        std::vector<double> counts(16 * 16 * 16);
        for (uint i = 0; i < 131072u; i++) {
            const vec3 u = numbersAt(walk, i);
            counts[(16 * cellOf(u.x, 16) + cellOf(u.y, 16)) * 16 + cellOf(u.z, 16)]++;
        }
        EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation) << nameOf(walk);
    }
}

}  // namespace
}  // namespace cleave
