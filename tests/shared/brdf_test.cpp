#include "shared/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "render/albedo_table.h"
#include "support/chi_square.h"

namespace cleave {
namespace {

constexpr double kPi = std::numbers::pi;
// How far the albedo of what should be white may be from 1, at the cosines below. They are sought from 0.005 on, and
// closer to the horizon the table's lookup is off by up to 0.004.
constexpr double kMostOff = 0.0025;

AlbedoTable table() {
    static const std::vector<SpecularAlbedo> entries = albedoTable();
    return {entries.data()};
}

// The oracle, from the formulas of the specification in double; nothing here is shared with brdf.h.
namespace oracle {

double dot(const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
dvec3 unit(const dvec3& v) { return v / std::sqrt(dot(v, v)); }
double alphaOf(double roughness) { return std::pow(std::max(roughness, 0.04), 2.0); }

double distribution(double alpha, const dvec3& h) {
    const double a2 = alpha * alpha, cosine = h.z / std::sqrt(dot(h, h));
    const double base = cosine * cosine * (a2 - 1.0) + 1.0;
    return cosine <= 0.0 ? 0.0 : a2 / (kPi * base * base);
}
double lambda(double alpha, const dvec3& v) {
    const double tangent2 = (v.x * v.x + v.y * v.y) / (v.z * v.z);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}
double fresnel(double f0, double cosine) { return f0 + (1.0 - f0) * std::pow(1.0 - std::fabs(cosine), 5.0); }
double specular(double f0, double alpha, const dvec3& v, const dvec3& l) {
    const dvec3 h = unit(v + l);
    const double shadowing = 1.0 / (1.0 + lambda(alpha, v) + lambda(alpha, l));
    return fresnel(f0, dot(v, h)) * distribution(alpha, h) * shadowing / (4.0 * v.z * l.z);
}

// The share of facets, weighted by D(h) cos(h), that are less inclined than h is tan^2 / (alpha^2 + tan^2). The tail is
// long, and more is reflected where its facets are seen edge-on, so that steps get smaller there: they are equal in x,
// where 1 - (1 - x)^2 is that share.
double tangentAt(double alpha, double x) {
    const double beyond = (1.0 - x) * (1.0 - x);
    return alpha * std::sqrt((1.0 - beyond) / beyond);
}
double tailSpacing(double alpha, const dvec3& h) {
    const double tangent2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
    return 2.0 * alpha / std::sqrt(alpha * alpha + tangent2);
}

// Light directions of two kinds, evenly spread by golden ratios, with what each stands for on the sphere: reflections
// of the viewer in facets of the distribution, and directions that crowd at the horizon. Any function is integrated as
// the balance heuristic (Veach and Guibas 1995) would, so that narrow lobes, broad ones and sums of both come out
// alike.
struct LightPoint {
    dvec3 light;
    double weight;
};
std::vector<LightPoint> quadrature(double roughness, const dvec3& viewer, int count) {
    const double alpha = alphaOf(roughness);
    std::vector<LightPoint> points;
    const auto add = [&](const dvec3& light) {
        if (light.z < kLeastCosine) return;
        const dvec3 h = unit(viewer + light);
        const double narrow = distribution(alpha, h) * h.z / (4.0 * dot(viewer, h)) / tailSpacing(alpha, h);
        const double broad = 1.0 / (4.0 * kPi * std::sqrt(light.z));
        points.push_back({light, 1.0 / (count * (narrow + broad))});
    };
    for (int i = 0; i < count; i++) {
        const double x = (i + 0.5) / count, angle = 2.0 * kPi * std::numbers::phi * i;
        const dvec3 around(std::cos(angle), std::sin(angle), 0.0), up(0.0, 0.0, 1.0);
        const dvec3 h = unit(around * tangentAt(alpha, x) + up);
        if (dot(viewer, h) > 0.0) add(2.0 * dot(viewer, h) * h - viewer);
        add(around * std::sqrt(1.0 - x * x * x * x) + up * (x * x));
    }
    return points;
}

// The specular lobe's albedo; for f0 = 1 the part of the light that does not hit a second facet.
double specularAlbedo(double f0, double roughness, double cosine, int count) {
    const dvec3 v(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double sum = 0.0;
    for (const auto& [l, weight] : quadrature(roughness, v, count))
        sum += specular(f0, alphaOf(roughness), v, l) * l.z * weight;
    return sum;
}

// What leaves in the end of light that stays after its first facet, one bounce after the other.
double scattered(double f0, double roughness) {
    double fresnelMean = 0.0, leaves = 0.0;
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps; i++) {
        const double cosine = (i + 0.5) / kSteps;
        fresnelMean += 2.0 * cosine / kSteps * fresnel(f0, cosine);
        leaves += 2.0 * cosine / kSteps * specularAlbedo(1.0, roughness, cosine, 5000);
    }
    double sum = 0.0, left = fresnelMean;  // after the first facet
    for (int bounce = 0; bounce < 100; bounce++) {
        left *= fresnelMean;
        sum += left * leaves;
        left *= 1.0 - leaves;
    }
    return sum;
}

}  // namespace oracle

dvec3 directionAt(double cosine, double turn) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return {sine * std::cos(2.0 * kPi * turn), sine * std::sin(2.0 * kPi * turn), cosine};
}
// Not to be inlined: GCC 12 compiles dvec3(vec3(d)) to d, without the rounding (-O2, its vectorizer).
[[gnu::noinline]] vec3 rounded(const dvec3& d) { return vec3(d); }
float number(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }
vec3 numbers(std::mt19937& random) {
    const float x = number(random), y = number(random);
    return {x, y, number(random)};
}
dvec3 anyDirection(std::mt19937& random) {
    const double cosine = 0.002 + 0.998 * number(random);
    return directionAt(cosine, number(random));
}
Surface anySurface(std::mt19937& random) {
    Surface s{numbers(random), number(random), number(random)};
    if (random() % 4 == 0) s.metallic = random() % 2 == 0 ? 0.0f : 1.0f;
    return s;
}
std::string nameOf(const Surface& s) {
    return "colour " + std::to_string(s.baseColour.x) + " " + std::to_string(s.baseColour.y) + " " +
           std::to_string(s.baseColour.z) + ", metallic " + std::to_string(s.metallic) + ", roughness " +
           std::to_string(s.roughness);
}
std::string nameOf(const dvec3& d) {
    return "direction " + std::to_string(d.x) + " " + std::to_string(d.y) + " " + std::to_string(d.z);
}

const std::vector<double> kRoughnesses = {0.0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0};
const std::vector<double> kCosines = {0.005, 0.02, 0.05, 0.1, 0.2, 0.4, 0.7, 0.95, 1.0};

TEST(Brdf, ggxIsTheClosedForm) {
    for (const double roughness : kRoughnesses) {
        const double alpha = oracle::alphaOf(roughness);
        double projected = 0.0, before = 0.0;
        constexpr int kSteps = 4000;
        for (int i = 0; i < kSteps; i++) {
            const double u = (i + 0.5) / kSteps, angle = 0.5 * kPi * u * u * u;
            const vec3 facet = rounded(directionAt(std::cos(angle), 0.1));
            const double value = ggx(static_cast<float>(alpha), facet);
            EXPECT_NEAR(value / oracle::distribution(alpha, dvec3(facet)), 1.0, 2e-6)
                << "roughness " << roughness << ", angle " << angle;
            const double next = std::pow((i + 1.0) / kSteps, 3.0) * 0.5 * kPi;
            projected += value * std::cos(angle) * 2.0 * kPi * (std::cos(before) - std::cos(next));
            before = next;
        }
        EXPECT_NEAR(projected, 1.0, 1e-3) << "roughness " << roughness;
    }
}

TEST(Brdf, specularPartIsTheSpecifications) {
    std::mt19937 random(1);
    for (int i = 0; i < 100000; i++) {
        const double roughness = number(random), f0 = number(random);
        const dvec3 v = anyDirection(random);
        dvec3 l = anyDirection(random);
        if (i % 2 == 0) l = oracle::unit(dvec3(-v.x, -v.y, v.z) + 0.1 * roughness * roughness * l);  // near the peak
        const vec3 viewer = rounded(v), light = rounded(l);
        const vec3 facet = unitVector(viewer + light);
        const float alpha = static_cast<float>(oracle::alphaOf(roughness));
        const double value =
            schlick(vec3(static_cast<float>(f0)), preciseDot(viewer, facet)).x * facetBrdf(alpha, facet, viewer, light);
        const double exact = oracle::specular(f0, alpha, dvec3(viewer), dvec3(light));
        ASSERT_NEAR(value / exact, 1.0, 2e-5)
            << "number " << i << " of seed 1: roughness " << roughness << ", " << nameOf(v) << ", " << nameOf(l);
    }
}

// alpha = 1 seen from above has a closed form: 1 - ln 2.
TEST(Brdf, albedoIsThatOfTheSpecularLobe) {
    EXPECT_NEAR(exactAlbedo(1.0, 1.0).loss, std::log(2.0), 5e-4);
    for (const double roughness : kRoughnesses) {
        for (const double cosine : kCosines) {
            const ExactAlbedo a = exactAlbedo(std::max(roughness, 0.04), cosine);
            EXPECT_NEAR(a.edge, oracle::specularAlbedo(0.0, roughness, cosine, 100000), 5e-4)
                << "roughness " << roughness << ", cosine " << cosine;
            EXPECT_NEAR(a.loss, 1.0 - oracle::specularAlbedo(1.0, roughness, cosine, 100000), 5e-4)
                << "roughness " << roughness << ", cosine " << cosine;
        }
    }
}

// At the entries and half-way between them.
TEST(Brdf, lookupOfTheAlbedoIsClose) {
    double most = 0.0, sum = 0.0;
    int count = 0;
    for (int i = 0; i <= 94; i++) {
        for (int j = 0; j <= 94; j++) {
            const float roughness = static_cast<float>(std::pow(0.2 + 0.8 * i / 94.0, 2.0));
            const float cosine = static_cast<float>(std::pow(j / 94.0, 4.0));
            const SpecularAlbedo a = lookedUpAlbedo(table(), roughness, cosine);
            const ExactAlbedo b = exactAlbedo(roughness, cosine);
            const double off = std::max(std::fabs(a.edge - b.edge), std::fabs(a.loss - b.loss));
            most = std::max(most, off);
            sum += off;
            count++;
        }
    }
    RecordProperty("mostOff", std::to_string(most));
    RecordProperty("meanOff", std::to_string(sum / count));
    EXPECT_LT(most, 0.004);
    EXPECT_LT(sum / count, 2e-4);
}

TEST(Brdf, lookupsStayInTheTable) {
    for (const float roughness : {-1.0f, 0.0f, 1.0f, 2.0f, infinity()}) {
        for (const float cosine : {-1.0f, 0.0f, 1.0f, 2.0f, infinity()}) {
            const SpecularAlbedo a = lookedUpAlbedo(table(), roughness, cosine);
            const float r = std::min(std::max(roughness, kLeastRoughness), 1.0f);
            const SpecularAlbedo b = lookedUpAlbedo(table(), r, std::min(std::max(cosine, 0.0f), 1.0f));
            EXPECT_EQ(a.edge, b.edge);
            EXPECT_EQ(a.loss, b.loss);
        }
    }
    const SpecularAlbedo last = table().at[kAlbedoRows * kAlbedoStride - 2];
    EXPECT_NEAR(lookedUpAlbedo(table(), 1.0f, 1.0f).loss, last.loss, 1e-6);
    EXPECT_NEAR(lookedUpAlbedo(table(), 0.0f, 0.0f).edge, table().at[0].edge, 1e-6);
}

TEST(Brdf, meanIsThatOfTheLookedUp) {
    for (const double roughness : kRoughnesses) {
        const float r = static_cast<float>(roughness);
        double edge = 0.0, loss = 0.0;
        constexpr int kSteps = 20000;
        for (int i = 0; i < kSteps; i++) {
            const double t = (i + 0.5) / kSteps, weight = 8.0 * std::pow(t, 7.0) / kSteps;
            const SpecularAlbedo a = lookedUpAlbedo(table(), r, static_cast<float>(std::pow(t, 4.0)));
            edge += weight * a.edge;
            loss += weight * a.loss;
        }
        EXPECT_NEAR(meanAlbedo(table(), r).edge, edge, 1e-6) << "roughness " << roughness;
        EXPECT_NEAR(meanAlbedo(table(), r).loss, loss, 1e-6) << "roughness " << roughness;
    }
}

struct Total {
    dvec3 albedo{0.0};
    double density = 0.0;
};
Total totalOf(const Surface& s, const dvec3& viewer, int count = 50000) {
    Total t;
    for (const auto& [light, weight] : oracle::quadrature(s.roughness, viewer, count)) {
        const BrdfValue value = evaluateBrdf(s, table(), vec3(viewer), vec3(light));
        t.albedo += weight * dvec3(value.timesCosine);
        t.density += weight * value.density;
    }
    return t;
}

// In a furnace they cannot be told from their surroundings.
TEST(Brdf, whiteSurfacesReflectAllThatComesIn) {
    double most = 0.0;
    for (const float metallic : {0.0f, 1.0f}) {
        for (const double roughness : kRoughnesses) {
            for (const double cosine : kCosines) {
                const Surface s{vec3(1.0f), metallic, static_cast<float>(roughness)};
                const dvec3 albedo = totalOf(s, directionAt(cosine, 0.1)).albedo;
                EXPECT_NEAR(albedo.x, 1.0, kMostOff) << nameOf(s) << ", cosine " << cosine;
                EXPECT_EQ(albedo.x, albedo.y);
                EXPECT_EQ(albedo.x, albedo.z);
                most = std::max(most, std::fabs(albedo.x - 1.0));
            }
        }
    }
    RecordProperty("mostOff", std::to_string(most));
}

TEST(Brdf, nothingReflectsMoreThanComesIn) {
    std::mt19937 random(2);
    for (int i = 0; i < 150; i++) {
        Surface s = anySurface(random);
        if (i % 5 == 0) s.baseColour = vec3(1.0f, 0.5f, 0.0f);
        const dvec3 v = directionAt(0.02 + 0.98 * number(random), number(random));
        const dvec3 albedo = totalOf(s, v, 30000).albedo;
        for (int k = 0; k < 3; k++) {
            EXPECT_LE(albedo[k], 1.0 + kMostOff) << "number " << i << " of seed 2: " << nameOf(s) << ", " << nameOf(v);
            EXPECT_GE(albedo[k], 0.0) << "number " << i << " of seed 2: " << nameOf(s) << ", " << nameOf(v);
        }
    }
}

// A black dielectric has the specular lobe of f0 = 0.04 and what bounces on; a smooth metal reflects its colour.
TEST(Brdf, coloursAreThoseOfTheSurface) {
    const dvec3 v = directionAt(0.9, 0.3);
    const dvec3 black = totalOf({vec3(0.0f), 0.0f, 0.1f}, v).albedo;
    EXPECT_NEAR(black.x, 0.04, 1e-3);
    const dvec3 metal = totalOf({vec3(0.9f, 0.5f, 0.1f), 1.0f, 0.1f}, v).albedo;
    EXPECT_NEAR(metal.x, 0.9, 1e-3);
    EXPECT_NEAR(metal.y, 0.5, 1e-3);
    EXPECT_NEAR(metal.z, 0.1, 1e-3);
    const dvec3 red = totalOf({vec3(0.8f, 0.1f, 0.0f), 0.0f, 1.0f}, v).albedo;
    EXPECT_NEAR(red.y - red.z, 0.1 * (1.0 - red.z), 1e-3);
    EXPECT_NEAR(red.x - red.z, 0.8 * (1.0 - red.z), 1e-3);
}

TEST(Brdf, metalsAreMoreSaturatedByBounces) {
    for (const double roughness : {0.3, 0.6, 1.0}) {
        for (const double f0 : {0.0, 0.3, 0.7}) {
            const Surface s{vec3(static_cast<float>(f0)), 1.0f, static_cast<float>(roughness)};
            for (const double cosine : {0.1, 0.5, 0.9}) {
                const double once = oracle::specularAlbedo(f0, roughness, cosine, 50000);
                const double stays = 1.0 - oracle::specularAlbedo(1.0, roughness, cosine, 50000);
                EXPECT_NEAR(totalOf(s, directionAt(cosine, 0.2)).albedo.x,
                            once + stays * oracle::scattered(f0, roughness), kMostOff)
                    << nameOf(s) << ", cosine " << cosine;
            }
        }
    }
}

TEST(Brdf, sharesOfTheLobesAddUpToOne) {
    std::mt19937 random(7);
    for (int i = 0; i < 10000; i++) {
        const Surface s = anySurface(random);
        const Lobes l = lobesOf(s, table());
        const SpecularAlbedo a = lookedUpAlbedo(table(), s.roughness, number(random));
        for (int k = 0; k < 3; k++) {
            ASSERT_NEAR(specularShare(l, a)[k] + l.scattered[k] * a.loss + restOf(l, a)[k], 1.0, 1e-6)
                << "number " << i << " of seed 7: " << nameOf(s);
        }
    }
}

TEST(Brdf, lightThatGoesTheOtherWayIsReflectedAlike) {
    std::mt19937 random(3);
    for (int i = 0; i < 100000; i++) {
        const Surface s = anySurface(random);
        const vec3 v(anyDirection(random)), l(anyDirection(random));
        const vec3 there = brdfTimesCosine(s, table(), v, l), back = brdfTimesCosine(s, table(), l, v);
        for (int k = 0; k < 3; k++) {
            const double a = static_cast<double>(there[k]) / l.z, b = static_cast<double>(back[k]) / v.z;
            ASSERT_NEAR(a, b, 2e-5 * a + 1e-7) << "number " << i << " of seed 3: " << nameOf(s);
        }
    }
}

// Facets that reflect the viewer into the surface are among those of the lobe's own density, and not of the whole's.
TEST(Brdf, densitiesAddUpToOne) {
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

TEST(Brdf, samplesFollowTheirDensity) {
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
TEST(Brdf, weightsAreSmall) {
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

TEST(Brdf, weightsAreTheBrdfTimesTheCosineByTheDensity) {
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
TEST(Brdf, meanWeightsAreTheAlbedo) {
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

bool isSound(const vec3& v) {
    for (int k = 0; k < 3; k++) {
        if (!isFinite(v[k]) || v[k] < 0.0f) return false;
    }
    return true;
}

std::vector<Surface> extremeSurfaces() {
    std::vector<Surface> all;
    for (const float colour : {0.0f, 1e-30f, 0.5f, 1.0f}) {
        for (const float metallic : {0.0f, 1e-7f, 0.5f, 1.0f - 0x1p-24f, 1.0f}) {
            for (const float roughness : {0.0f, 0.04f, 0.5f, 1.0f})
                all.push_back({vec3(colour, 1.0f - colour, colour), metallic, roughness});
        }
    }
    return all;
}
std::vector<vec3> grazingDirections() {
    std::vector<vec3> all;
    for (const double turn : {0.0, 0.25, 0.5, 0.9}) {
        for (const double cosine : {1e-6, 1.1e-6, 1e-4, 1e-2, 0.5, 1.0}) all.push_back(vec3(directionAt(cosine, turn)));
    }
    return all;
}

TEST(Brdf, everythingIsFinite) {
    std::vector<vec3> corners;
    for (const float x : {0.0f, 0x1p-24f, 0.5f, 1.0f - 0x1p-24f}) {
        for (const float y : {0.0f, 0.5f, 1.0f - 0x1p-24f}) {
            for (const float z : {0.0f, 0.5f, 1.0f - 0x1p-24f}) corners.push_back(vec3(x, y, z));
        }
    }
    for (const Surface& s : extremeSurfaces()) {
        for (const vec3& v : grazingDirections()) {
            SCOPED_TRACE(nameOf(s) + ", viewer " + nameOf(dvec3(v)));
            for (const vec3& l : grazingDirections()) {
                const BrdfValue value = evaluateBrdf(s, table(), v, l);
                ASSERT_TRUE(isSound(value.timesCosine)) << nameOf(dvec3(l));
                ASSERT_TRUE(isFinite(value.density) && value.density >= 0.0f) << nameOf(dvec3(l));
            }
            for (const vec3& u : corners) {
                const BrdfSample sample = sampleBrdf(s, table(), v, u);
                ASSERT_TRUE(isSound(sample.weight)) << u.x << " " << u.y << " " << u.z;
                ASSERT_TRUE(isFinite(sample.density) && sample.density >= 0.0f);
                ASSERT_TRUE(isFinite(sample.direction.x) && isFinite(sample.direction.y));
                ASSERT_GE(sample.direction.z, kLeastCosine);
            }
        }
    }
}

TEST(Brdf, nothingIsReflectedBelowTheHorizon) {
    const vec3 up(0.6f, 0.0f, 0.8f);
    for (const Surface& s : extremeSurfaces()) {
        for (const vec3& below : {vec3(1.0f, 0.0f, 0.0f), vec3(0.0f, 1.0f, -0.0f), vec3(0.6f, 0.0f, -0.8f),
                                  vec3(0.0f, 0.0f, -1.0f), vec3(std::numeric_limits<float>::quiet_NaN())}) {
            EXPECT_EQ(brdfTimesCosine(s, table(), up, below), vec3(0.0f));
            EXPECT_EQ(brdfTimesCosine(s, table(), below, up), vec3(0.0f));
            EXPECT_EQ(brdfDensity(s, table(), up, below), 0.0f);
            EXPECT_EQ(brdfDensity(s, table(), below, up), 0.0f);
            EXPECT_EQ(sampleBrdf(s, table(), below, vec3(0.5f)).density, 0.0f);
            EXPECT_EQ(sampleBrdf(s, table(), below, vec3(0.5f)).weight, vec3(0.0f));
        }
    }
}

}  // namespace
}  // namespace cleave
