#include "figures/survey_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace cleave::test {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// The first line that has all the words, from the table whose title begins with `title`.
std::string rowOf(const std::string& text, const std::string& title, const std::vector<std::string>& words) {
    bool inTable = false;
    for (const std::string& line : linesOf(text)) {
        if (line.starts_with(title)) inTable = true;
        if (line.empty()) inTable = false;
        if (inTable && std::all_of(words.begin(), words.end(),
                                   [&](const std::string& word) { return line.find(word) != std::string::npos; }))
            return line;
    }
    return "no row";
}

std::string withSingleSpaces(const std::string& text) {
    std::string single;
    for (const char c : text)
        if (c != ' ' || !single.ends_with(' ')) single += c;
    return single;
}

SurveyVariant variantOf(double oneThread, double allThreads, double sahCost) {
    SurveyVariant v;
    v.oneThread = {oneThread, 2 * oneThread, oneThread};
    v.oneCpu = {oneThread / 2, oneThread / 2};
    v.allThreads = {allThreads};
    v.upload = {3.0};
    v.primary = {40.0};
    v.diffuse = {60.0 + oneThread};
    v.rayCost = sahCost / 2;
    v.statistics.sahCost = sahCost;
    v.statistics.references = 1234567;
    return v;
}

// Pure, its one thread takes 4 ms more, its trees cost a tenth more and hold fewer references.
SurveyBuilder builderOf(std::string_view name, double oneThread, double allThreads, double sahCost) {
    SurveyBuilder b;
    b.builder = {name};
    b.ours = variantOf(oneThread, allThreads, sahCost);
    b.pure = variantOf(oneThread + 4, allThreads + 1, 1.1 * sahCost);
    b.pure->statistics.references = 765432;
    return b;
}

SurveyMedians someMedians() {
    SurveyMedians medians{1000.0, 500.0, {}};
    for (const char* builder : {"spatial-median", "object-median"})
        for (const AxisChoice axes : {AxisChoice::all, AxisChoice::widest, AxisChoice::cycle})
            for (const uint32_t size : kMedianLeafSizes)
                medians.trees.push_back({{builder}, axes, size, 1000.0 + size, 600.0 + 10 * size, 12345});
    medians.trees.back().sahCost = 15000.0;
    return medians;
}

SurveyScene sceneOf(const std::string& name, uint64_t triangles) {
    SurveyScene scene;
    scene.name = name;
    scene.triangles = triangles;
    scene.model = surveyModelOf(name, triangles);
    scene.standsIn = scene.model != nullptr && name != scene.model->name;
    scene.builders = {builderOf("exact", 100, 60, 1000), builderOf("exact-nlog2n", 150, 150, 1000),
                      builderOf("hunt-one", 20, 20, 1100), builderOf("shevtsov", 25, 12.5, 1050)};
    scene.builders[0].pure->statistics.sahCost = 1000;  // the same tree
    scene.builders[0].pure->rayCost = 500;
    scene.medians = someMedians();
    scene.complexity.straddling = {0.5, 0.625, 9};
    scene.complexity.worstCut = 2.5;
    return scene;
}

TEST(SurveyPublished, ModelsAreMatchedByNameAndSize) {
    ASSERT_NE(surveyModelOf("bunny", 69451), nullptr);
    EXPECT_EQ(surveyModelOf("bunny", 69451)->name, "bunny");
    EXPECT_EQ(surveyModelOf("Dragon_vrip", 871414)->name, "dragon");
    EXPECT_EQ(surveyModelOf("armadillo_346k", 345928)->name, "armadillo");
    EXPECT_EQ(surveyModelOf("armadillo_86k", 86482), nullptr);
    EXPECT_EQ(surveyModelOf("default", 69451), nullptr);
    EXPECT_EQ(surveyModelOf("", 804), nullptr);
}

// Against the survey's text, by sums over its columns.
TEST(SurveyPublished, FiguresAddUpToTheSurveys) {
    const auto sum = [](SurveyTable table, std::string_view builder) {
        double total = 0;
        for (const SurveyModel& model : surveyModels())
            total += publishedFigure(table, model.name, builder).value_or(0.0);
        return total;
    };
    EXPECT_NEAR(sum(SurveyTable::exactBuilds, "exact-nlog2n"), 3018.26, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::exactBuilds, "exact"), 1174.23, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::huntBuilds, "hunt-all"), 1.66, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::huntBuilds, "hunt-hybrid"), 1.37, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::huntBuilds, "hunt-one"), 0.80, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::huntBuilds, "exact"), 8.2, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::huntRendering, "hunt-one"), 7.72, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::shevtsovToImage, "exact"), 61.0, 1e-9);
    EXPECT_NEAR(sum(SurveyTable::shevtsovToImage, "shevtsov"), 1.551, 1e-9);
    EXPECT_FALSE(publishedFigure(SurveyTable::huntRendering, "dragon", "hunt-all"));
}

TEST(SurveyTables, ShowMeasuredBesidePublished) {
    const std::string text = surveyTables({sceneOf("bunny", 69451)}, 2);
    const auto has = [&](const std::string& title, const std::vector<std::string>& row,
                         const std::vector<std::string>& figures) {
        const std::string line = withSingleSpaces(rowOf(text, title, row));
        for (const std::string& figure : figures)
            EXPECT_NE(line.find(figure), std::string::npos) << figure << ": " << line;
    };
    // Pure, ours, published.
    has("Table 5.1", {"bunny"}, {"69,451", " 77.0 52.0 1.48 ", " 75.0 50.0 1.50 ", " 6.70 3.20 2.09"});
    has("Table 6.1", {"hunt-one"}, {" 12.0 4.33 ", " 10.0 5.00 ", " 20.0 3.00 ", " 1.00 ", " 0.11 29.09"});
    has("Table 6.1", {"shevtsov"}, {" 14.5 3.59 ", " 12.5 4.00 ", " 12.5 4.80 ", " 2.00 "});
    has("Table 6.2", {"hunt-one"}, {" 21.00 21.00 765,432", "-40.00 10.00 10.00 1,234,567", " 7.72"});
    has("Table 7.1", {"shevtsov"}, {" 13.5 56.5 1.84 ", " 12.5 55.5 1.86 ", " 0.104 46.2"});
    has("Section 4", {"bunny", "spatial-median", "all"}, {" 0.1 0.4 1.6 6.4 ", " 22.0 28.0 52.0 148.0"});
    has("Section 4", {"object-median", "cycle"}, {" 1400.0 "});
    has("Section 5", {"bunny"}, {"0.50 n^0.62", "2.5 sqrt(n)"});
}

TEST(SurveyTables, ModelsThatAreNotThereHaveTheirPublishedFiguresOnly) {
    const std::string text = surveyTables({sceneOf("bunny", 69451)}, 2);
    const std::string thai = rowOf(text, "Table 5.1", {"thai"});
    EXPECT_NE(thai.find("430.00"), std::string::npos) << thai;
    EXPECT_NE(thai.find(" - "), std::string::npos) << thai;
    EXPECT_NE(rowOf(text, "Table 7.1", {"buddha"}).find("32.300"), std::string::npos);
    EXPECT_EQ(rowOf(text, "Table 6.2", {"armadillo"}), "no row");
}

TEST(SurveyTables, LabelStandInsAndScenesOfOthers) {
    const std::string text = surveyTables({sceneOf("armadillo_346k", 345928), sceneOf("room", 12)}, 1);
    EXPECT_NE(rowOf(text, "Table 5.1", {"armadillo_346k*", "345,928", "16.00"}), "no row");
    EXPECT_NE(text.find("* armadillo_346k stands in for the survey's armadillo"), std::string::npos);
    EXPECT_NE(rowOf(text, "Table 5.1", {"room ", "75.0"}), "no row");
    EXPECT_EQ(text.find("room*"), std::string::npos);
}

TEST(SurveyTables, FitTheTerminal) {
    SurveyScene scene = sceneOf("armadillo_346k", 345928);
    for (SurveyBuilder& b : scene.builders) {  // slow ones on a large scene
        for (SurveyVariant* v : {&b.ours, &*b.pure}) {
            v->primary = {123456.7};
            v->diffuse = {1234567.8};
            v->oneThread = v->oneCpu = v->allThreads = {1234567.8};
        }
    }
    scene.builders.push_back(builderOf("spatial-median", 1234567.8, 1234567.8, 12345.67));
    for (const std::string& line : linesOf(surveyTables({scene}, 64))) EXPECT_LE(line.size(), 120u) << line;
}

}  // namespace
}  // namespace cleave::test
