#include "shared/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/brdf_cases.h"
#include "support/chi_square.h"

namespace cleave {
namespace {

using oracle::kPi;

// Facets that reflect the viewer into the surface are among those of the lobe's own density, and not of the whole's.
TEST(BrdfSampling, densitiesAddUpToOne) {
    for (const double roughness : kRoughnesses) {
        const float alpha = static_cast<float>(oracle::alphaOf(roughness));
        for (const double cosine : kCosines) {
            const dvec3 v = directionAt(cosine, 0.7);
            constexpr int kRings = 200, kSpokes = 400;
            double sum = 0.0, above = 0.0;
            for (int i = 0; i < kRings; i++) {
                for (int j = 0; j < kSpokes; j++) {
                    const double tangent = oracle::tangentAt(alpha, (i + 0.5) / kRings);
                    const dvec3 h = directionAt(1.0 / std::sqrt(1.0 + tangent * tangent), (j + 0.5) / kSpokes);
                    const double dot = oracle::dot(v, h);
                    if (dot <= 0.0) continue;
                    const double perFacet =
                        oracle::distribution(alpha, h) * h.z * kRings * kSpokes / oracle::tailSpacing(alpha, h);
                    const double part = 4.0 * dot * reflectionDensity(alpha, vec3(h), vec3(v)) / perFacet;
                    sum += part;
                    if (2.0 * dot * h.z > v.z) above += part;
                }
            }
            EXPECT_NEAR(sum, 1.0, 2e-3) << "roughness " << roughness << ", cosine " << cosine;
            const Surface s{vec3(0.8f), 0.0f, static_cast<float>(roughness)};
            const Lobes lobes = lobesOf(s, table());
            const LobeChances chances =
                lobeChances(lobes, lookedUpAlbedo(table(), s.roughness, static_cast<float>(cosine)));
            EXPECT_NEAR(chances.facet + chances.horizon + chances.cosine, 1.0, 1e-6);
            EXPECT_NEAR(totalOf(s, v).density, 1.0 - chances.facet * (1.0 - above), 2e-3)
                << "roughness " << roughness << ", cosine " << cosine;
        }
    }
}

// Cells of light directions: by height and angle, and by the facet between them and the viewer, whose cells are small
// where the specular lobe is. The last cell is for samples without a direction.
class Cells {
  public:
    static constexpr size_t kRings = 16, kSpokes = 24, kNone = kRings * kSpokes, kCount = kNone + 1;
    Cells(double alpha, const dvec3& viewer) : alpha_(alpha), viewer_(viewer) {}

    size_t byLight(const dvec3& light) const { return cell(light.z, light); }
    size_t byFacet(const dvec3& light) const {
        const dvec3 h = viewer_ + light;
        const double square = (h.x * h.x + h.y * h.y) / (h.z * h.z * alpha_ * alpha_);
        return cell(square / (1.0 + square), h);
    }

  private:
    double alpha_;
    dvec3 viewer_;

    size_t cell(double height, const dvec3& d) const {
        const double turn = std::atan2(d.y, d.x) / (2.0 * kPi) + 0.5;
        const auto place = [](double x, size_t n) {
            return std::min(static_cast<size_t>(x * static_cast<double>(n)), n - 1);
        };
        return place(height, kRings) * kSpokes + place(turn, kSpokes);
    }
};

struct Histogram {
    std::vector<double> byLight = std::vector<double>(Cells::kCount), byFacet = byLight;
    void add(const Cells& cells, const dvec3& light, double weight) {
        byLight[cells.byLight(light)] += weight;
        byFacet[cells.byFacet(light)] += weight;
    }
    void addNone(double weight) {
        byLight[Cells::kNone] += weight;
        byFacet[Cells::kNone] += weight;
    }
};

void samplesFollowTheirDensity(const Surface& s, const dvec3& viewer, unsigned seed) {
    constexpr int kSamples = 40000;
    const vec3 v(viewer);
    const Cells cells(oracle::alphaOf(s.roughness), viewer);
    Histogram expected, counts;
    double all = 0.0;
    for (const auto& [light, weight] : oracle::quadrature(s.roughness, viewer, 120000)) {
        const double part = weight * brdfDensity(s, table(), v, vec3(light));
        expected.add(cells, light, kSamples * part);
        all += part;
    }
    expected.addNone(kSamples * std::max(0.0, 1.0 - all));
    std::mt19937 random(seed);
    for (int i = 0; i < kSamples; i++) {
        const BrdfSample sample = sampleBrdf(s, table(), v, numbers(random));
        if (sample.density > 0.0f)
            counts.add(cells, dvec3(sample.direction), 1.0);
        else
            counts.addNone(1.0);
    }
    EXPECT_LT(std::fabs(chiSquareDeviation(counts.byLight, expected.byLight)), 4.5);
    EXPECT_LT(std::fabs(chiSquareDeviation(counts.byFacet, expected.byFacet)), 4.5);
}

TEST(BrdfSampling, samplesFollowTheirDensity) {
    unsigned seed = 100;
    for (const double roughness : {0.0, 0.1, 0.3, 0.6, 1.0}) {
        for (const float metallic : {0.0f, 0.5f, 1.0f}) {
            for (const double cosine : {0.05, 0.4, 0.8, 1.0}) {
                const dvec3 v = directionAt(cosine, 0.1 * (seed % 10));
                const Surface s{vec3(0.9f, 0.4f, 0.1f), metallic, static_cast<float>(roughness)};
                SCOPED_TRACE(::testing::Message() << nameOf(s) << ", cosine " << cosine << ", seed " << seed);
                samplesFollowTheirDensity(s, v, seed);
                seed++;
            }
        }
    }
}

// A rare sample of a large weight is a bright dot in a picture.
TEST(BrdfSampling, weightsAreSmall) {
    std::mt19937 random(6);
    for (const double roughness : kRoughnesses) {
        for (const float metallic : {0.0f, 0.5f, 1.0f}) {
            const Surface s{vec3(1.0f, 0.5f, 0.0f), metallic, static_cast<float>(roughness)};
            float most = 0.0f;
            for (int i = 0; i < 40000; i++) {
                const double cosine = std::pow(number(random), 2.0);
                const vec3 weight = sampleBrdf(s, table(), vec3(directionAt(cosine, 0.4)), numbers(random)).weight;
                most = std::max({most, weight.x, weight.y, weight.z});
            }
            EXPECT_LT(most, 12.0f) << nameOf(s) << ", seed 6";
        }
    }
}

TEST(BrdfSampling, weightsAreTheBrdfTimesTheCosineByTheDensity) {
    std::mt19937 random(4);
    int found = 0;
    for (int i = 0; i < 100000; i++) {
        const Surface s = anySurface(random);
        const vec3 v(anyDirection(random));
        const BrdfSample sample = sampleBrdf(s, table(), v, numbers(random));
        if (sample.density == 0.0f) continue;
        found++;
        const double length = std::sqrt(oracle::dot(dvec3(sample.direction), dvec3(sample.direction)));
        ASSERT_NEAR(length, 1.0, 2e-6) << "number " << i << " of seed 4: " << nameOf(s);
        ASSERT_EQ(sample.density, brdfDensity(s, table(), v, sample.direction)) << "number " << i << " of seed 4";
        const vec3 value = brdfTimesCosine(s, table(), v, sample.direction);
        for (int k = 0; k < 3; k++) {
            const double weight = static_cast<double>(value[k]) / sample.density;
            ASSERT_NEAR(sample.weight[k], weight, 1e-6 * weight) << "number " << i << " of seed 4: " << nameOf(s);
        }
    }
    EXPECT_GT(found, 90000);
}

// The furnace by Monte Carlo: the mean weight is the albedo.
TEST(BrdfSampling, meanWeightsAreTheAlbedo) {
    std::mt19937 random(5);
    for (int i = 0; i < 60; i++) {
        const Surface s = anySurface(random);
        const dvec3 v = directionAt(0.02 + 0.98 * number(random), number(random));
        constexpr int kSamples = 30000;
        dvec3 sum(0.0), squares(0.0);
        for (int j = 0; j < kSamples; j++) {
            const dvec3 weight(sampleBrdf(s, table(), vec3(v), numbers(random)).weight);
            sum += weight;
            squares += weight * weight;
        }
        const dvec3 albedo = totalOf(s, v).albedo, mean = sum / double(kSamples);
        for (int k = 0; k < 3; k++) {
            const double variance = squares[k] / kSamples - mean[k] * mean[k];
            EXPECT_NEAR(mean[k], albedo[k], 4.0 * std::sqrt(variance / kSamples) + 2e-4)
                << "number " << i << " of seed 5: " << nameOf(s) << ", " << nameOf(v);
        }
    }
}

}  // namespace
}  // namespace cleave
