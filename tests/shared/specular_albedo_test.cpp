#include "shared/specular_albedo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/brdf_cases.h"

namespace cleave {
namespace {

// alpha = 1 seen from above has a closed form: 1 - ln 2.
TEST(SpecularAlbedo, albedoIsThatOfTheSpecularLobe) {
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
TEST(SpecularAlbedo, lookupOfTheAlbedoIsClose) {
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

TEST(SpecularAlbedo, lookupsStayInTheTable) {
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

TEST(SpecularAlbedo, meanIsThatOfTheLookedUp) {
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

}  // namespace
}  // namespace cleave
