#include "figures/fitted_costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace cleave {
namespace {

constexpr int kTerms = 3;  // of a ray, an inner node, a triangle
constexpr uint32_t kAllTerms = (1u << kTerms) - 1u;

glm::dvec3 termsOf(const WorkSample& s) { return {1.0, s.inner, s.triangles}; }

// Least squares over the terms of a set; the others are 0. Nothing where the samples do not tell them apart.
std::optional<glm::dvec3> leastSquares(std::span<const WorkSample> samples, uint32_t set) {
    glm::dmat3 normal(0.0);
    glm::dvec3 right(0.0);
    for (const WorkSample& sample : samples) {
        glm::dvec3 terms = termsOf(sample) / sample.nanoseconds;
        for (int i = 0; i < kTerms; ++i)
            if ((set >> i & 1u) == 0) terms[i] = 0.0;
        normal += glm::outerProduct(terms, terms);
        right += terms;
    }
    double scale = 1.0;
    for (int i = 0; i < kTerms; ++i) {
        if ((set >> i & 1u) == 0) normal[i][i] = 1.0;
        scale *= normal[i][i];
    }
    constexpr double kSingular = 1e-12;  // of the determinant, to the product of the diagonal
    if (!(glm::determinant(normal) > kSingular * scale)) return std::nullopt;
    return glm::inverse(normal) * right;
}

double squaredError(std::span<const WorkSample> samples, const glm::dvec3& costs) {
    double sum = 0.0;
    for (const WorkSample& sample : samples) {
        const double error = glm::dot(costs, termsOf(sample)) / sample.nanoseconds - 1.0;
        sum += error * error;
    }
    return sum;
}

}  // namespace

// With three terms, the sets of those that are not 0 can be tried one by one.
std::optional<FittedCosts> fitCosts(std::span<const WorkSample> samples) {
    if (samples.size() < kTerms) return std::nullopt;
    std::optional<glm::dvec3> best;
    for (uint32_t set = 1; set <= kAllTerms; ++set) {
        const std::optional<glm::dvec3> costs = leastSquares(samples, set);
        if (!costs || glm::any(glm::lessThan(*costs, glm::dvec3(0.0)))) continue;
        if (!best || squaredError(samples, *costs) < squaredError(samples, *best)) best = costs;
    }
    if (!best) return std::nullopt;
    FittedCosts fitted{(*best)[0], (*best)[1], (*best)[2], 0.0, 0.0, samples.size()};
    for (const WorkSample& sample : samples) {
        const double error = std::abs(fitted.nanosecondsOf(sample) / sample.nanoseconds - 1.0);
        fitted.meanError += error / static_cast<double>(samples.size());
        fitted.largestError = std::max(fitted.largestError, error);
    }
    return fitted;
}

std::optional<SahCosts> sahCostsOf(const FittedCosts& fitted) {
    if (!(fitted.inner > 0.0) || !(fitted.triangle > 0.0)) return std::nullopt;
    SahCosts costs = kDefaultCosts;
    const double unit = double{costs.traverse} / fitted.inner;
    costs.intersect = std::clamp(static_cast<float>(unit * fitted.triangle), kLeastCost, kMostCost);
    return costs;
}

}  // namespace cleave
