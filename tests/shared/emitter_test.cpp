#include "shared/emitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "render/alias_table.h"
#include "support/chi_square.h"

namespace cleave {
namespace {

constexpr double kMostDeviation = 4.5;  // standard deviations; seeds are fixed, so what passes once always does

float number(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }
vec2 pair(std::mt19937& random) {
    const float x = number(random);
    return {x, number(random)};
}

// Weights from 1e-6 to 1e6, and items that are not their indices.
std::vector<double> weightsOf(size_t count, std::mt19937& random) {
    std::uniform_real_distribution<double> exponent(-6.0, 6.0);
    std::vector<double> weights;
    for (size_t i = 0; i < count; ++i) weights.push_back(std::pow(10.0, exponent(random)));
    return weights;
}
std::vector<uint32_t> itemsOf(size_t count) {
    std::vector<uint32_t> items(count);
    for (size_t i = 0; i < count; ++i) items[i] = static_cast<uint32_t>(1000 + 3 * i);
    return items;
}

TEST(Emitter, SlotsAreTheUpperWordOfTheProduct) {
    std::mt19937 random(1);
    for (int i = 0; i < 100000; ++i) {
        const auto word = static_cast<uint32_t>(random());
        const auto count = static_cast<uint32_t>(random() >> random() % 32);
        ASSERT_EQ(slotOf(word, count), uint64_t{word} * count >> 32) << word << " of " << count;
    }
    EXPECT_EQ(slotOf(0xFFFFFFFFu, 0xFFFFFFFFu), 0xFFFFFFFEu);
    EXPECT_EQ(slotOf(0xFFFFFFFFu, 1), 0u);
}

// What the slots give each item, added up, is its share of the weights.
TEST(Emitter, TablesHoldTheSharesOfTheWeights) {
    for (const size_t count : {1u, 2u, 3u, 17u, 1000u}) {
        std::mt19937 random(2);
        const std::vector<double> weights = weightsOf(count, random);
        const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
        std::vector<double> shares(count);
        const std::vector<AliasSlot> slots = aliasTable(weights, itemsOf(count));
        ASSERT_EQ(slots.size(), count);
        for (const AliasSlot& slot : slots) {
            ASSERT_GE(slot.chance, 0.0f);
            ASSERT_LE(slot.chance, 1.0f);
            shares.at((slot.first - 1000) / 3) += slot.chance / static_cast<double>(count);
            shares.at((slot.second - 1000) / 3) += (1.0 - slot.chance) / static_cast<double>(count);
        }
        for (size_t i = 0; i < count; ++i) EXPECT_NEAR(shares[i], weights[i] / all, 1e-7) << i << " of " << count;
    }
}

TEST(Emitter, TrianglesAreDrawnAsOftenAsTheirWeightsSay) {
    constexpr size_t kCount = 50, kDraws = 1000000;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.1, 5.0);
    std::vector<double> weights(kCount), counts(kCount), expected;
    for (double& weight : weights) weight = uniform(random);
    const std::vector<AliasSlot> slots = aliasTable(weights, itemsOf(kCount));
    for (size_t i = 0; i < kDraws; ++i) {
        const auto word = static_cast<uint32_t>(random());
        counts.at((triangleOf(slots[slotOf(word, kCount)], number(random)) - 1000) / 3)++;
    }
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (const double weight : weights) expected.push_back(kDraws * weight / all);
    EXPECT_LT(std::fabs(chiSquareDeviation(counts, expected)), kMostDeviation) << "seed 3";
}

// By the weight of a vertex, which is 1 - sqrt of a uniform number, and by where the point is across.
TEST(Emitter, PlacesOnATriangleAreAllAlike) {
    std::mt19937 random(4);
    std::vector<double> counts(256);
    for (int i = 0; i < 200000; ++i) {
        const vec2 p = placeOnTriangle(pair(random));
        ASSERT_GE(p.x, 0.0f);
        ASSERT_GE(p.y, 0.0f);
        ASSERT_LE(double{p.x} + double{p.y}, 1.0 + 1e-6);
        const double rest = 1.0 - double{p.x}, even = rest * rest, across = rest > 0.0 ? double{p.y} / rest : 0.0;
        const auto place = [](double x) { return static_cast<size_t>(std::min(std::max(x, 0.0) * 16.0, 15.0)); };
        counts[16 * place(even) + place(across)]++;
    }
    EXPECT_LT(std::fabs(chiSquareDeviation(counts)), kMostDeviation) << "seed 4";
}

// Of a triangle as it is seen from a point (van Oosterom and Strackee 1983).
double solidAngle(const Triangle& t, const vec3& from) {
    const dvec3 a = dvec3(t.a) - dvec3(from), b = dvec3(t.b) - dvec3(from), c = dvec3(t.c) - dvec3(from);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return 2.0 * std::fabs(std::atan2(glm::dot(a, glm::cross(b, c)), below));
}

vec3 normalOf(const Triangle& t) { return vec3(glm::normalize(glm::cross(dvec3(t.b - t.a), dvec3(t.c - t.a)))); }
double areaOf(const Triangle& t) { return 0.5 * glm::length(glm::cross(dvec3(t.b - t.a), dvec3(t.c - t.a))); }

// The mean of 1 / density over points that are drawn with that density is the solid angle, whatever the scale.
TEST(Emitter, ItsDensityIsPerSolidAngle) {
    for (const float unit : {1e-18f, 1.0f, 1e15f}) {
        const Triangle triangle{vec3(-1, 2, 0) * unit, vec3(2, 2.5, 0.5) * unit, vec3(0, 3, -2) * unit};
        const vec3 point = vec3(0.5f, 0.1f, -0.3f) * unit;
        const vec3 emission(0.5f, 2.0f, 0.25f);
        Emitter emitter{triangle, {}, normalOf(triangle), emission, brightnessOf(emission)};
        // The only one: its power is all there is.
        const Emitters emitters{1, static_cast<float>(1.0 / std::sqrt(2.75 * areaOf(triangle)))};
        std::mt19937 random(5);
        double sum = 0.0, squares = 0.0;
        constexpr int kDraws = 100000;
        for (int i = 0; i < kDraws; ++i) {
            emitter.at = placeOnTriangle(pair(random));
            const Arrival arrival = arrivalFromEmitter(emitters, emitter, point);
            ASSERT_TRUE(arrival.density > 0.0f && isFinite(arrival.density));
            ASSERT_EQ(arrival.irradiance, emission);
            sum += 1.0 / double{arrival.density};
            squares += 1.0 / double{arrival.density} / double{arrival.density};
        }
        const double mean = sum / kDraws, error = std::sqrt((squares / kDraws - mean * mean) / kDraws);
        std::printf("seed 5: %.5f, standard error %.5f, exact %.5f\n", mean, error, solidAngle(triangle, point));
        EXPECT_NEAR(mean, solidAngle(triangle, point), 4.0 * error) << unit;
    }
}

// The ray towards a point ends before the emitter's plane, by less than a thousandth of the way where it is not seen
// from the side.
TEST(Emitter, RaysEndBeforeIt) {
    std::mt19937 random(6);
    std::normal_distribution<float> normal;
    const auto vector = [&] { return vec3(normal(random), normal(random), normal(random)); };
    for (int i = 0; i < 100000; ++i) {
        const vec3 far = vector() * (i % 3 == 0 ? 1000.0f : 0.0f);
        const Triangle triangle{far + vector(), far + vector(), far + vector()};
        const vec3 point = vector() * (i % 5 == 0 ? 100.0f : 1.0f);
        const Emitter emitter{triangle, placeOnTriangle(pair(random)), normalOf(triangle), vec3(1.0f), 3.0f};
        const Arrival arrival = arrivalFromEmitter({1, 1.0f}, emitter, point);
        const dvec3 plane =
            glm::normalize(glm::cross(dvec3(triangle.b) - dvec3(triangle.a), dvec3(triangle.c) - dvec3(triangle.a)));
        const double along = glm::dot(plane, dvec3(arrival.towards));
        const double meets = glm::dot(plane, dvec3(triangle.a) - dvec3(point)) / along;
        if (std::fabs(along) < 1e-3) continue;
        ASSERT_LT(arrival.distance, meets) << i;
        if (std::fabs(along) > 0.1) {
            ASSERT_GT(arrival.distance, 0.999 * meets) << i;
        }
    }
}

}  // namespace
}  // namespace cleave
