#include "shared/ggx.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/brdf_cases.h"

namespace cleave {
namespace {

using oracle::kPi;

TEST(Ggx, ggxIsTheClosedForm) {
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

TEST(Ggx, specularPartIsTheSpecifications) {
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

}  // namespace
}  // namespace cleave
