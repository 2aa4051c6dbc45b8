// What brdf.h is judged by: the formulas of glTF's specification in double, and integrals over the light. Nothing here
// is shared with shaders/shared/ggx.h and brdf.h.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "shared/language.h"

namespace cleave::oracle {

constexpr double kPi = std::numbers::pi;
constexpr double kHorizon = 1e-6;  // directions below have no light

inline double dot(const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline dvec3 unit(const dvec3& v) { return v / std::sqrt(dot(v, v)); }
inline double alphaOf(double roughness) { return std::pow(std::max(roughness, 0.04), 2.0); }

inline double distribution(double alpha, const dvec3& h) {
    const double a2 = alpha * alpha, cosine = h.z / std::sqrt(dot(h, h));
    const double base = cosine * cosine * (a2 - 1.0) + 1.0;
    return cosine <= 0.0 ? 0.0 : a2 / (kPi * base * base);
}
inline double lambda(double alpha, const dvec3& v) {
    const double tangent2 = (v.x * v.x + v.y * v.y) / (v.z * v.z);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}
inline double fresnel(double f0, double cosine) { return f0 + (1.0 - f0) * std::pow(1.0 - std::fabs(cosine), 5.0); }
inline double specular(double f0, double alpha, const dvec3& v, const dvec3& l) {
    const dvec3 h = unit(v + l);
    const double shadowing = 1.0 / (1.0 + lambda(alpha, v) + lambda(alpha, l));
    return fresnel(f0, dot(v, h)) * distribution(alpha, h) * shadowing / (4.0 * v.z * l.z);
}

// The share of facets, weighted by D(h) cos(h), that are less inclined than h is tan^2 / (alpha^2 + tan^2). The tail is
// long, and more is reflected where its facets are seen edge-on, so that steps get smaller there: they are equal in x,
// where 1 - (1 - x)^2 is that share.
inline double tangentAt(double alpha, double x) {
    const double beyond = (1.0 - x) * (1.0 - x);
    return alpha * std::sqrt((1.0 - beyond) / beyond);
}
inline double tailSpacing(double alpha, const dvec3& h) {
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
inline std::vector<LightPoint> quadrature(double roughness, const dvec3& viewer, int count) {
    const double alpha = alphaOf(roughness);
    std::vector<LightPoint> points;
    const auto add = [&](const dvec3& light) {
        if (light.z < kHorizon) return;
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
inline double specularAlbedo(double f0, double roughness, double cosine, int count) {
    const dvec3 v(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double sum = 0.0;
    for (const auto& [l, weight] : quadrature(roughness, v, count))
        sum += specular(f0, alphaOf(roughness), v, l) * l.z * weight;
    return sum;
}

// What leaves in the end of light that stays after its first facet, one bounce after the other.
inline double scattered(double f0, double roughness) {
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

}  // namespace cleave::oracle
