#include "figures/error_rows.h"

#include <gtest/gtest.h>

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

// Two builders: one builds in 10 ms and traces in 10, the other in 100 and 9.
ReportPage pageOf(const std::string& scene) {
    SceneErrors errors;
    errors.name = scene;
    errors.triangles = 12345;
    errors.tree = errors.rays = {rowOf(8, 10, scene), rowOf(0, 100, scene)};
    errors.rays[1].builder = errors.tree[1].builder = "exact";
    errors.rayTimes = {{"gpu", {10, 10, 10, 5}, {}, {10, 10, 10, 5}}, {"exact", {100, 100, 100, 5}, {}, {9, 9, 9, 5}}};
    errors.hits = {rowOf(20, 5, scene)};
    errors.hits[0].settings = "stack, plain";
    errors.judged = {{100000, 2, 1, 3000000}};
    ReportPage page;
    page.version = "1.2.3";
    page.commandLine = "cleave report '" + scene + "'";
    page.device = "a device";
    page.driver = "a driver 4.5";
    page.scenes = {errors};
    page.leftOut = {{"twin", "the same tree"}};
    return page;
}

TEST(ReportPage, LoadsNothingAndRunsNothing) {
    const std::string html = reportHtml(pageOf("a.glb"));
    for (const char* part : {"<script", "src=", "href=", "@import", "url("})
        EXPECT_EQ(html.find(part), std::string::npos) << part;
    for (const char* part : {"a device", "a driver 4.5", "cleave 1.2.3", "the same tree", "12,345 triangles"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    EXPECT_EQ(html, reportHtml(pageOf("a.glb"))) << "the same figures, the same page";
}

TEST(ReportPage, NamesOfFilesAreText) {
    const std::string html = reportHtml(pageOf("<img src=x onerror='alert(1)'>.glb"));
    EXPECT_EQ(html.find("<img"), std::string::npos);
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

}  // namespace
}  // namespace cleave::test
