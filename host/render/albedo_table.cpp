#include "render/albedo_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cleave {

namespace {

constexpr int kSteps = 32;  // across the viewer's plane; twice as many along it

// Abscissae in [0, 1] that crowd at both ends, where facets are seen edge-on, and their weights. The sum over midpoints
// converges fast, since the weights vanish there together with their derivatives.
template <size_t n>
struct Steps {
    std::array<double, n> at;
    std::array<double, n> weight;
};
template <size_t n>
Steps<n> steps() {
    Steps<n> s;
    for (size_t i = 0; i < n; i++) {
        const double x = (static_cast<double>(i) + 0.5) / n;
        s.at[i] = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
        s.weight[i] = 30.0 * x * x * (1.0 - x) * (1.0 - x) / n;
    }
    return s;
}

double smithRootOf(double alpha, double cosine) {
    return std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

// The viewer is in the plane of x and z. `facet` is not of unit length.
class Reflection {
  public:
    Reflection(double alpha, double cosine)
        : alpha_(alpha), cosine_(cosine), sine_(std::sqrt(1.0 - cosine * cosine)), root_(smithRootOf(alpha, cosine)) {}

    // Of the light from a visible facet: the part that leaves the surface is G2 / G1 of it, since the rest hits
    // another.
    ExactAlbedo at(const dvec3& facet) const {
        const double length = std::sqrt(facet.x * facet.x + facet.y * facet.y + facet.z * facet.z);
        const double dot = std::max(0.0, (sine_ * facet.x + cosine_ * facet.z) / length);
        const double light = 2.0 * dot * facet.z / length - cosine_;
        if (light <= 0.0) return {0.0, 1.0};
        const double leaves = light * (cosine_ + root_) / (light * root_ + cosine_ * smithRootOf(alpha_, light));
        const double c = 1.0 - dot;
        return {leaves * (c * c * c * c * c), std::max(0.0, 1.0 - leaves)};
    }

  private:
    double alpha_, cosine_, sine_, root_;
};

// The mean of a linear interpolant between entries at equal steps of the cosine's fourth root t, weighted by the
// cosine: of 2 c dc = 8 t^7 dt. Exact, so that the lobes of brdf.h reflect exactly what they should.
SpecularAlbedo meanOfRow(const SpecularAlbedo* row) {
    double edge = 0.0, loss = 0.0;
    for (uint j = 0; j + 1 < kAlbedoColumns; j++) {
        const double step = 1.0 / (kAlbedoColumns - 1), a = j * step, b = (j + 1) * step;
        const double whole = std::pow(b, 8) - std::pow(a, 8);
        const double second = (8.0 / 9.0 * (std::pow(b, 9) - std::pow(a, 9)) - a * whole) / step;
        const double first = whole - second;
        edge += first * row[j].edge + second * row[j + 1].edge;
        loss += first * row[j].loss + second * row[j + 1].loss;
    }
    return {static_cast<float>(edge), static_cast<float>(loss)};
}

}  // namespace

// Integrates over the facets that the viewer sees, in the space where Heitz (2018) stretches them to a hemisphere:
// there all of its projection towards the viewer counts alike, and angles a (out of the viewer's plane) and b (in it)
// make it smooth.
ExactAlbedo exactAlbedo(double roughness, double cosine) {
    static const Steps<kSteps> across = steps<kSteps>();
    static const Steps<2 * kSteps> along = steps<2 * kSteps>();
    const double alpha = roughness * roughness, root = smithRootOf(alpha, cosine);
    const double viewX = alpha * std::sqrt(1.0 - cosine * cosine) / root, viewZ = cosine / root;
    const double lowest = -std::asin(std::min(viewZ, 1.0)), quarter = 0.5 * std::numbers::pi, range = quarter - lowest;
    const Reflection reflection(alpha, cosine);
    ExactAlbedo sum{0.0, 0.0};
    for (size_t i = 0; i < across.at.size(); i++) {
        const double cosA = std::cos(quarter * across.at[i]), sinA = std::sin(quarter * across.at[i]);
        for (size_t j = 0; j < along.at.size(); j++) {
            const double b = lowest + range * along.at[j];
            const double y = cosA * std::sin(b), z = cosA * std::cos(b);
            const dvec3 facet(alpha * (z * viewX - y * viewZ), alpha * sinA, std::max(0.0, y * viewX + z * viewZ));
            const ExactAlbedo e = reflection.at(facet);
            const double weight = across.weight[i] * along.weight[j] * cosA * z;
            sum.edge += weight * e.edge;
            sum.loss += weight * e.loss;
        }
    }
    const double scale = 2.0 * range / (1.0 + viewZ);  // 4 / (pi (1 + viewZ)), times the ranges of a and b
    return {scale * sum.edge, scale * sum.loss};
}

std::vector<SpecularAlbedo> albedoTable() {
    std::vector<SpecularAlbedo> table(kAlbedoRows * kAlbedoStride);
    for (uint i = 0; i < kAlbedoRows; i++) {
        const double root = kLeastAlbedoRoot + (1.0 - kLeastAlbedoRoot) * i / (kAlbedoRows - 1);
        SpecularAlbedo* const row = table.data() + i * kAlbedoStride;
        for (uint j = 0; j < kAlbedoColumns; j++) {
            const ExactAlbedo e = exactAlbedo(root * root, std::pow(j / (kAlbedoColumns - 1.0), 4));
            row[j] = {static_cast<float>(e.edge), static_cast<float>(e.loss)};
        }
        row[kAlbedoColumns] = meanOfRow(row);
    }
    return table;
}

}  // namespace cleave
