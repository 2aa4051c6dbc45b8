#include "figures/error_rows.h"

#include <gtest/gtest.h>

#include "figures/report_json.h"
#include "figures/report_page.h"

namespace cleave::test {
namespace {

ErrorRow rowOf(double error, double ms, const std::string& scene = "a.glb") {
    ErrorRow row;
    row.scene = scene;
    row.builder = "gpu";
    row.settings = "defaults";
    row.error = row.errorLow = row.errorHigh = error;
    row.time = {ms, 0.5 * ms, 2.0 * ms, 5};
    return row;
}

std::vector<bool> frontOf(std::vector<ErrorRow> rows) {
    markPareto(rows);
    std::vector<bool> front;
    for (const ErrorRow& row : rows) front.push_back(row.pareto);
    return front;
}
using Front = std::vector<bool>;

TEST(Pareto, OnlyWhatNoOtherBeats) {
    EXPECT_EQ(frontOf({}), Front{});
    EXPECT_EQ(frontOf({rowOf(3, 7)}), Front{true});
    EXPECT_EQ(frontOf({rowOf(0, 100), rowOf(5, 10), rowOf(6, 20), rowOf(40, 1), rowOf(50, 2)}),
              (Front{true, true, false, true, false}));
}

TEST(Pareto, OfEqualErrorsTheQuickerIsOnIt) {
    EXPECT_EQ(frontOf({rowOf(1, 10), rowOf(1, 9)}), (Front{false, true}));
    EXPECT_EQ(frontOf({rowOf(2, 10), rowOf(1, 10)}), (Front{false, true}));
}

TEST(Pareto, EqualRowsAreOnItTogether) {
    EXPECT_EQ(frontOf({rowOf(1, 10), rowOf(1, 10), rowOf(0, 20)}), (Front{true, true, true}));
    EXPECT_EQ(frontOf({rowOf(1, 10), rowOf(1, 10), rowOf(0, 10)}), (Front{false, false, true}));
}

TEST(Pareto, ScenesDoNotCompete) {
    EXPECT_EQ(frontOf({rowOf(9, 90, "a.glb"), rowOf(1, 10, "b.glb")}), (Front{true, true}));
}

TEST(Pareto, ErrorsMayBeBelowZero) { EXPECT_EQ(frontOf({rowOf(0, 10), rowOf(-2, 10)}), (Front{false, true})); }

TEST(ErrorRows, HaveTheKeysThatScriptsUse) {
    std::vector<ErrorRow> rows{rowOf(12.5, 10)};
    markPareto(rows);
    const Json json = errorRowsJson(rows).at(0);
    EXPECT_EQ(json["scene"], "a.glb");
    EXPECT_EQ(json["builder"], "gpu");
    EXPECT_EQ(json["settings"], "defaults");
    EXPECT_EQ(json["error"], 12.5);
    EXPECT_EQ(json["ms"], 10.0);
    EXPECT_EQ(json["msLow"], 5.0);
    EXPECT_EQ(json["msHigh"], 20.0);
    EXPECT_EQ(json["runs"], 5);
    EXPECT_EQ(json["pareto"], true);
}

TEST(Spread, OfOddAndEvenNumbersOfRuns) {
    const Spread odd = spreadOf({3.0, 1.0, 2.0});
    EXPECT_EQ(odd.median, 2.0);
    EXPECT_EQ(odd.low, 1.0);
    EXPECT_EQ(odd.high, 3.0);
    EXPECT_EQ(odd.runs, 3u);
    EXPECT_EQ(spreadOf({4.0, 1.0}).median, 2.5);
}

AllSetErrors setsOf(double ms) {
    AllSetErrors sets;
    sets[0].rays = 1000;
    sets[0].runs = {ms};
    return sets;
}

// Two builders: one builds in 10 ms and traces in 10, the other in 100 and 9.
SceneErrors sceneNamed(const std::string& name) {
    SceneErrors scene;
    scene.name = name;
    scene.triangles = 12345;
    scene.trees.resize(2);
    scene.trees[0] = {"exact", kDefaultSettings, {100}, true, 50.0, {3, 2, 1}, 7, 9, {1, 2}, {0, 3}};
    scene.trees[1] = {"gpu", kDefaultSettings, {10}, true, 54.0, {4, 2, 1}, 7, 9, {1, 2}, {0, 3}};
    scene.traced.resize(2);
    scene.traced[0].sets = setsOf(9);
    scene.traced[1].tree = 1;
    scene.traced[1].sets = setsOf(10);
    scene.traced[0].counts[0] = {10, 2, 5};
    scene.traced[1].counts[0] = {20, 2, 5};
    scene.ways = {{"stack", "plain", setsOf(5)}};
    scene.ways[0].sets[0].judged = 100000;
    scene.ways[0].sets[0].wrong = 2;
    scene.fits = {{"all", {0.0, 3.0, 4.0, 0.01, 0.02, 5}}};
    scene.pictures = {{"steps", "gpu", "iVBORw=="}};
    return scene;
}

TEST(ErrorRows, OfTreesRaysAndHits) {
    const SceneErrors scene = sceneNamed("a.glb");
    const std::vector<ErrorRow> tree = treeRows(scene), rays = rayRows(scene), hits = hitRows(scene);
    ASSERT_EQ(tree.size(), 2u);
    EXPECT_EQ(tree[0].error, 0.0);
    EXPECT_NEAR(tree[1].error, 8.0, 1e-12) << "54 for 50";
    EXPECT_EQ(tree[1].time.median, 10.0);
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_NEAR(rays[1].error, 100.0 / 9.0, 1e-12) << "10 for 9";
    EXPECT_TRUE(rays[1].pareto);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].error, 20.0, 1e-12) << "2 of 100,000, per million";
    EXPECT_EQ(hits[0].settings, "stack, plain");
}

TEST(ErrorRows, ATreeWithoutACostHasNone) {
    SceneErrors scene = sceneNamed("a.glb");
    scene.trees[1].hasCost = false;
    EXPECT_EQ(treeRows(scene).size(), 1u);
    EXPECT_EQ(rayRows(scene).size(), 2u);
}

TEST(ErrorRows, RunsOfSetsAddUpRunByRun) {
    AllSetErrors sets = setsOf(1);
    sets[0].runs = {1, 2, 30};
    sets[2].runs = {10, 5, 1};
    const Spread all = timeOfAll(sets);
    EXPECT_EQ(all.median, 11.0);
    EXPECT_EQ(all.low, 7.0);
    EXPECT_EQ(all.high, 31.0);
    EXPECT_EQ(all.runs, 3u);
    EXPECT_EQ(timeOfAll({}).runs, 0u);
}

ReportPage pageOf(const std::string& scene) {
    ReportPage page;
    page.version = "1.2.3";
    page.commandLine = "cleave report '" + scene + "'";
    page.device = "a device";
    page.driver = "a driver 4.5";
    page.settings.traversal = "stack";
    page.scenes = {sceneNamed(scene)};
    page.leftOut = {{"twin", "the same tree"}};
    return page;
}

TEST(ReportPage, LoadsNothingAndRunsNothing) {
    std::string html = reportHtml(pageOf("a.glb"));
    for (const char* part : {"a device", "a driver 4.5", "cleave 1.2.3", "the same tree", "12,345 triangles"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    EXPECT_EQ(html, reportHtml(pageOf("a.glb"))) << "the same figures, the same page";
    const std::string picture = "src=\"data:image/png;base64,iVBORw==\"";
    ASSERT_NE(html.find(picture), std::string::npos);
    html.erase(html.find(picture), picture.size());
    for (const char* part : {"<script", "src=", "href=", "@import", "url("})
        EXPECT_EQ(html.find(part), std::string::npos) << part;
}

TEST(ReportPage, NamesOfFilesAreText) {
    const std::string html = reportHtml(pageOf("<img src=x onerror='alert(1)'>.glb"));
    EXPECT_EQ(html.find("<img src=x"), std::string::npos);
    EXPECT_NE(html.find("&lt;img src=x"), std::string::npos);
}

TEST(ReportPage, MarksTheLeastTimeToAnImage) {
    const std::string html = reportHtml(pageOf("a.glb"));
    // 10 + 10 k against 100 + 9 k: they meet at k = 90.
    for (const char* best : {"\u2605 20.0 (", "\u2605 110.0 (", "\u2605 1000 (", "\u2605 9100 ("})
        EXPECT_NE(html.find(best), std::string::npos) << best;
}

TEST(ReportPage, ASceneThatFailedSaysWhy) {
    ReportPage page = pageOf("a.glb");
    page.scenes.push_back({});
    page.scenes.back().name = "bad.glb";
    page.scenes.back().failure = "bad.glb: is <cut> short";
    const std::string html = reportHtml(page);
    EXPECT_NE(html.find("No figures: bad.glb: is &lt;cut&gt; short"), std::string::npos);
}

TEST(ReportPage, SaysThatItWentOn) {
    ReportPage page = pageOf("a.glb");
    EXPECT_EQ(reportHtml(page).find("taken before one"), std::string::npos);
    page.wentOn = true;
    EXPECT_NE(reportHtml(page).find("taken before one"), std::string::npos);
}

// What an interrupted run had noted is what the next one reads.
TEST(SceneErrors, SurviveAsJson) {
    const SceneErrors scene = sceneNamed("a.glb");
    EXPECT_EQ(nlohmann::json(nlohmann::json(scene.trees[1]).get<TreeErrors>()), nlohmann::json(scene.trees[1]));
    EXPECT_EQ(nlohmann::json(scene.trees[1]).get<TreeErrors>().leafHistogram, scene.trees[1].leafHistogram);
    EXPECT_EQ(nlohmann::json(scene.ways[0].sets[0]).get<SetErrors>().wrong, 2u);
    EXPECT_EQ(nlohmann::json(scene.pictures).get<std::vector<ReportPicture>>()[0].png, "iVBORw==");
}

TEST(ReportJson, HasWhatScriptsLookFor) {
    const Json json = reportJson(pageOf("a.glb"));
    EXPECT_EQ(json["errors"]["tree"].size(), 2u);
    EXPECT_EQ(json["predictions"][1]["expected"]["inner"], 4.0);
    EXPECT_EQ(json["predictions"][1]["primary"]["inner"], 20.0);
    EXPECT_EQ(json["fitted"][0]["innerNs"], 3.0);
    EXPECT_EQ(json["leftOut"][0]["what"], "twin");
}

}  // namespace
}  // namespace cleave::test
