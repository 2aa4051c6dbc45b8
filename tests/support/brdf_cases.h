// Surfaces and directions that the tests of brdf.h share.
#pragma once

#include <random>
#include <string>

#include "render/albedo_table.h"
#include "shared/brdf.h"
#include "support/brdf_oracle.h"

namespace cleave {

inline AlbedoTable table() {
    static const std::vector<SpecularAlbedo> entries = albedoTable();
    return {entries.data()};
}

inline const std::vector<double> kRoughnesses = {0.0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0};
inline const std::vector<double> kCosines = {0.005, 0.02, 0.05, 0.1, 0.2, 0.4, 0.7, 0.95, 1.0};

inline dvec3 directionAt(double cosine, double turn) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return {sine * std::cos(2.0 * oracle::kPi * turn), sine * std::sin(2.0 * oracle::kPi * turn), cosine};
}
// Not to be inlined: GCC 12 compiles dvec3(vec3(d)) to d, without the rounding (-O2, its vectorizer).
[[gnu::noinline]] inline vec3 rounded(const dvec3& d) { return vec3(d); }
inline float number(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }
inline vec3 numbers(std::mt19937& random) {
    const float x = number(random), y = number(random);
    return {x, y, number(random)};
}
inline dvec3 anyDirection(std::mt19937& random) {
    const double cosine = 0.002 + 0.998 * number(random);
    return directionAt(cosine, number(random));
}
inline Surface anySurface(std::mt19937& random) {
    Surface s{numbers(random), number(random), number(random)};
    if (random() % 4 == 0) s.metallic = random() % 2 == 0 ? 0.0f : 1.0f;
    return s;
}
inline std::string nameOf(const Surface& s) {
    return "colour " + std::to_string(s.baseColour.x) + " " + std::to_string(s.baseColour.y) + " " +
           std::to_string(s.baseColour.z) + ", metallic " + std::to_string(s.metallic) + ", roughness " +
           std::to_string(s.roughness);
}
inline std::string nameOf(const dvec3& d) {
    return "direction " + std::to_string(d.x) + " " + std::to_string(d.y) + " " + std::to_string(d.z);
}

// What a surface reflects of light from everywhere, and the integral of its density.
struct Total {
    dvec3 albedo{0.0};
    double density = 0.0;
};
inline Total totalOf(const Surface& s, const dvec3& viewer, int count = 50000) {
    Total t;
    for (const auto& [light, weight] : oracle::quadrature(s.roughness, viewer, count)) {
        const BrdfValue value = evaluateBrdf(s, table(), vec3(viewer), vec3(light));
        t.albedo += weight * dvec3(value.timesCosine);
        t.density += weight * value.density;
    }
    return t;
}

}  // namespace cleave
