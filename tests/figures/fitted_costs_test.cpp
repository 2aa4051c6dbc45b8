#include "figures/fitted_costs.h"

#include <gtest/gtest.h>

#include <vector>

namespace cleave::test {
namespace {

WorkSample sample(double inner, double triangles, double ray, double perInner, double perTriangle) {
    return {inner, triangles, ray + perInner * inner + perTriangle * triangles};
}

TEST(FittedCosts, AreFoundAgain) {
    std::vector<WorkSample> samples;
    for (const auto& [inner, triangles] : {std::pair{10.0, 2.0}, {40.0, 1.0}, {20.0, 9.0}, {15.0, 4.0}})
        samples.push_back(sample(inner, triangles, 30.0, 4.0, 7.0));
    const std::optional<FittedCosts> fitted = fitCosts(samples);
    ASSERT_TRUE(fitted);
    EXPECT_NEAR(fitted->ray, 30.0, 1e-6);
    EXPECT_NEAR(fitted->inner, 4.0, 1e-8);
    EXPECT_NEAR(fitted->triangle, 7.0, 1e-8);
    EXPECT_LT(fitted->largestError, 1e-9);
    EXPECT_EQ(fitted->samples, 4u);
    const std::optional<SahCosts> costs = sahCostsOf(*fitted);
    ASSERT_TRUE(costs);
    EXPECT_EQ(costs->traverse, 15.0f);
    EXPECT_NEAR(costs->intersect, 15.0 * 7.0 / 4.0, 1e-5);
}

// Unbounded least squares would give the ray -5.
TEST(FittedCosts, AreNeverBelowZero) {
    std::vector<WorkSample> samples;
    for (const auto& [inner, triangles] : {std::pair{10.0, 2.0}, {40.0, 1.0}, {20.0, 9.0}, {15.0, 4.0}})
        samples.push_back(sample(inner, triangles, -5.0, 4.0, 7.0));
    const std::optional<FittedCosts> fitted = fitCosts(samples);
    ASSERT_TRUE(fitted);
    EXPECT_EQ(fitted->ray, 0.0);
    EXPECT_GT(fitted->inner, 3.0);
    EXPECT_GT(fitted->triangle, 5.0);
    EXPECT_GT(fitted->largestError, 0.0);
    EXPECT_GE(fitted->largestError, fitted->meanError);
}

TEST(FittedCosts, NeedSamplesThatDiffer) {
    const std::vector<WorkSample> two{sample(10, 2, 1, 1, 1), sample(20, 3, 1, 1, 1)};
    EXPECT_FALSE(fitCosts(two));
    // All the same: one term explains them, and which cannot be said; no constants follow.
    const std::vector<WorkSample> same(5, sample(10, 2, 1, 1, 1));
    const std::optional<FittedCosts> fitted = fitCosts(same);
    ASSERT_TRUE(fitted);
    EXPECT_FALSE(sahCostsOf(*fitted));
}

}  // namespace
}  // namespace cleave::test
