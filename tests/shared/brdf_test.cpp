#include "shared/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/brdf_cases.h"

namespace cleave {
namespace {

// How far the albedo of what should be white may be from 1. The cosines below begin at 0.005; closer to the horizon the
// table's lookup is off by up to 0.004.
constexpr double kMostOff = 0.0025;

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

// A smooth metal reflects its colour; a dielectric its own, in every direction, or what its facets do if that is more:
// the black one shows these alone.
TEST(Brdf, coloursAreThoseOfTheSurface) {
    const dvec3 metal = totalOf({vec3(0.9f, 0.5f, 0.1f), 1.0f, 0.1f}, directionAt(0.9, 0.3)).albedo;
    EXPECT_NEAR(metal.x, 0.9, 1e-3);
    EXPECT_NEAR(metal.y, 0.5, 1e-3);
    EXPECT_NEAR(metal.z, 0.1, 1e-3);
    EXPECT_NEAR(totalOf({vec3(0.0f), 0.0f, 0.1f}, directionAt(0.9, 0.3)).albedo.x, 0.04, 1e-3);
    for (const float roughness : {0.1f, 0.5f, 1.0f})
        for (const double cosine : {0.1, 0.5, 1.0}) {
            const dvec3 v = directionAt(cosine, 0.3);
            const double facets = totalOf({vec3(0.0f), 0.0f, roughness}, v).albedo.x;
            const dvec3 total = totalOf({vec3(0.9f, 0.6f, 0.3f), 0.0f, roughness}, v).albedo;
            const double colour[3] = {0.9, 0.6, 0.3};
            for (int k = 0; k < 3; k++)
                EXPECT_NEAR(total[k], std::max(colour[k], facets), 0.04 * colour[k])
                    << "component " << k << ", roughness " << roughness << ", cosine " << cosine;
        }
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

TEST(Brdf, sharesOfTheLobesAddUpToTheBaseColourOfADielectric) {
    std::mt19937 random(7);
    for (int i = 0; i < 10000; i++) {
        Surface s = anySurface(random);
        s.metallic = 0.0f;
        const Lobes l = lobesOf(s, table());
        const SpecularAlbedo a = lookedUpAlbedo(table(), s.roughness, number(random));
        for (int k = 0; k < 3; k++) {
            const float facets = specularShare(l, a)[k] + l.scattered[k] * a.loss;
            ASSERT_NEAR(facets + underOf(l, a)[k], std::max(facets, s.baseColour[k]), 1e-6)
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
