#include "figures/picture_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "figures/report_json.h"
#include "figures/report_page.h"

namespace cleave::test {
namespace {

// Errors of 8 / sqrt(samples) per cent, in 10 ms a sample.
SceneErrors sceneNamed(const std::string& name, double factor = 1.0) {
    SceneErrors scene;
    scene.name = name;
    scene.paths = {"gpu", 96, 54, 256, 8, 0.5, {}};
    for (const uint32_t samples : {4u, 16u, 64u}) {
        const double error = factor * 8.0 / std::sqrt(samples), ms = 10.0 * samples;
        scene.paths.pictures.push_back({samples, {error, error}, {0.75, 0.5, 0.25}, {ms, ms + 2.0, ms - 2.0}});
    }
    return scene;
}

TEST(LogSlope, OfPowersIsTheirExponent) {
    const LogPoints points{{1, 8}, {4, 4}, {16, 2}};
    EXPECT_NEAR(*logSlope({&points, 1}), -0.5, 1e-12);
    const LogPoint centre = centreOf(points);
    EXPECT_NEAR(centre.x, 4.0, 1e-12);
    EXPECT_NEAR(centre.y, 4.0, 1e-12);
}

// log2: (0, 0), (1, 2), (2, 1): slope (1 * 1) / 2 by hand.
TEST(LogSlope, IsThatOfLeastSquares) {
    const LogPoints points{{1, 1}, {2, 4}, {4, 2}};
    EXPECT_NEAR(*logSlope({&points, 1}), 0.5, 1e-12);
}

TEST(LogSlope, OfGroupsLeavesOutHowTheyLieToEachOther) {
    const std::vector<LogPoints> groups{{{1, 8}, {4, 4}}, {{100, 800}, {400, 400}}, {}, {{7, 7}}};
    EXPECT_NEAR(*logSlope(groups), -0.5, 1e-12);
}

TEST(LogSlope, NeedsTwoPlaces) {
    EXPECT_EQ(logSlope({}), std::nullopt);
    const LogPoints points{{3, 8}, {3, 4}};
    EXPECT_EQ(logSlope({&points, 1}), std::nullopt);
}

TEST(PictureRows, AreOfTheRootMeanSquareAndTheMedian) {
    SceneErrors scene = sceneNamed("a.glb");
    scene.paths.pictures[0].errors = {1.0, 7.0};
    const std::vector<ErrorRow> rows = pictureRows(scene);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_NEAR(rows[0].error, 5.0, 1e-12);
    EXPECT_EQ(rows[0].errorLow, 1.0);
    EXPECT_EQ(rows[0].errorHigh, 7.0);
    EXPECT_EQ(rows[0].time.median, 40.0);
    EXPECT_EQ(rows[0].time.runs, 3u);
    EXPECT_EQ(rows[0].settings, "4 samples");
    EXPECT_TRUE(rows[0].pareto && rows[1].pareto && rows[2].pareto);
}

TEST(PictureRows, TellTheSlopeToScripts) {
    ReportPage page;
    page.scenes = {sceneNamed("a.glb"), sceneNamed("b.glb", 3.0)};
    const Json json = reportJson(page);
    ASSERT_EQ(json["errors"]["picture"].size(), 6u);
    const Json& row = json["errors"]["picture"][1];
    EXPECT_EQ(row["scene"], "a.glb");
    EXPECT_EQ(row["builder"], "gpu");
    EXPECT_EQ(row["samples"], 16);
    EXPECT_NEAR(row["error"].get<double>(), 2.0, 1e-12);
    EXPECT_EQ(row["ms"], 160.0);
    EXPECT_EQ(row["msLow"], 158.0);
    EXPECT_EQ(row["similarity"], 0.5);
    EXPECT_NEAR(json["picture"]["slope"].get<double>(), -0.5, 1e-12);
    EXPECT_NEAR(json["picture"]["slopeBySamples"].get<double>(), -0.5, 1e-12);
    ASSERT_EQ(json["picture"]["scenes"].size(), 2u);
    EXPECT_NEAR(json["picture"]["scenes"][1]["slope"].get<double>(), -0.5, 1e-12);
    EXPECT_EQ(json["picture"]["scenes"][1]["referenceError"], 0.5);
}

TEST(PictureRows, WithoutPicturesThereIsNoSlope) {
    ReportPage page;
    page.scenes.resize(1);
    const Json json = reportJson(page);
    EXPECT_EQ(json["errors"]["picture"], Json::array());
    EXPECT_TRUE(json["picture"]["slope"].is_null());
    EXPECT_EQ(json["picture"]["scenes"], Json::array());
}

// A picture that is not off at all has no logarithm.
TEST(PictureRows, WithoutAnErrorAreNotFitted) {
    SceneErrors scene = sceneNamed("a.glb");
    for (double& error : scene.paths.pictures[1].errors) error = 0.0;
    EXPECT_EQ(errorsByTime(scene).size(), 2u);
    EXPECT_NEAR(*logSlope(std::vector<LogPoints>{errorsBySamples(scene)}), -0.5, 1e-12);
}

}  // namespace
}  // namespace cleave::test
