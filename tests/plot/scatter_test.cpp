#include "plot/scatter.h"

#include <gtest/gtest.h>

#include <regex>

#include "plot/count_of.h"

namespace cleave::test {
namespace {

PlotPoint pointAt(double x, double y, const std::string& label, bool onFront) {
    return {0, x, y, x, x, y, y, label, onFront};
}

// x in 1 to 100, y in 0 to 10. With margins of 5 % the area is 546 x 352 for 2.2 decades and for 11 units.
ScatterPlot threePoints() {
    ScatterPlot plot{"a plot", "time, ms", "error, %", Scale::log, Scale::linear, {"one"}, {}};
    plot.points = {pointAt(1, 10, "quick", true), pointAt(10, 5, "middling", true), pointAt(100, 0, "exact", true)};
    return plot;
}

TEST(Scatter, PutsPointsWhereTheyBelong) {
    const std::string svg = scatterSvg(threePoints());
    // 64 + 546 (0.1, 1.1, 2.1) / 2.2 and 366 - 352 (10.5, 5.5, 0.5) / 11.
    for (const char* place : {"translate(88.8 30.0)", "translate(337.0 190.0)", "translate(585.2 350.0)"})
        EXPECT_EQ(countOf(svg, place), 1u) << place << " in\n" << svg;
}

TEST(Scatter, TheFrontIsAStaircase) {
    const std::string svg = scatterSvg(threePoints());
    EXPECT_NE(svg.find("d=\"M88.8 14.0H88.8V30.0H337.0V190.0H585.2V350.0H610.0\""), std::string::npos) << svg;
    ScatterPlot plot = threePoints();
    plot.points[1].onFront = false;
    EXPECT_NE(scatterSvg(plot).find("d=\"M88.8 14.0H88.8V30.0H585.2V350.0H610.0\""), std::string::npos);
}

// Viewers of SVG refuse what HTML forgives: every attribute has a quoted value.
TEST(Scatter, IsWellFormed) {
    const std::regex tag("</?[a-z]+( [A-Za-z][A-Za-z0-9-]*=\"[^\"<>]*\")*/?>");
    const std::string rest = std::regex_replace(scatterSvg(threePoints()), tag, "");
    EXPECT_EQ(rest.find_first_of("<>"), std::string::npos) << rest;
}

TEST(Scatter, IsTheSameTextEveryTime) { EXPECT_EQ(scatterSvg(threePoints()), scatterSvg(threePoints())); }

TEST(Scatter, SpreadsAreBarsWhereTheyCanBeSeen) {
    ScatterPlot plot = threePoints();
    EXPECT_EQ(countOf(scatterSvg(plot), "stroke=\"#8a8a8a\""), 0u);
    plot.points[1].xLow = 5.0;
    plot.points[1].xHigh = 20.0;
    plot.points[1].yHigh = 5.01;
    const std::string svg = scatterSvg(plot);
    EXPECT_EQ(countOf(svg, "stroke=\"#8a8a8a\""), 1u) << "of the time; that of the error is within the mark";
    // 64 + 546 (0.1 + log10 of 5 and 20) / 2.2
    EXPECT_NE(svg.find("stroke=\"#8a8a8a\" stroke-width=\"1.2\" x1=\"262.3\" y1=\"190.0\" x2=\"411.7\" y2=\"190.0\""),
              std::string::npos)
        << svg;
}

TEST(Scatter, LabelsOfAnyOriginAreText) {
    ScatterPlot plot = threePoints();
    plot.title = plot.xTitle = plot.series[0] = plot.points[0].label = "</svg><script>alert('1')</script>&";
    const std::string svg = scatterSvg(plot);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_EQ(countOf(svg, "</svg>"), 1u);
    EXPECT_NE(svg.find("&lt;script&gt;alert(&#39;1&#39;)"), std::string::npos);
}

TEST(Scatter, LabelsGiveWayToEachOther) {
    ScatterPlot plot = threePoints();
    for (int i = 0; i < 40; ++i) plot.points.push_back(pointAt(10, 5, "one of many", false));
    const std::string svg = scatterSvg(plot);
    const size_t labels = countOf(svg, ">one of many</text>");
    EXPECT_GE(labels, 1u);
    EXPECT_LE(labels, 8u) << "no more than there are places";
    EXPECT_EQ(countOf(svg, ">middling</text>"), 1u) << "what is on the front comes first";
    EXPECT_EQ(countOf(svg, "one of many: "), 40u) << "every point has its title";
}

TEST(Scatter, ZeroIsShownAndWhereAllIsZeroOneUnit) {
    ScatterPlot plot = threePoints();
    plot.points = {pointAt(1, 0, "a", true), pointAt(2, 0, "b", false)};
    EXPECT_NE(scatterSvg(plot).find("translate(88.8 350.0)"), std::string::npos) << "5 % above the lower end";
    plot.points = {pointAt(1, 40, "a", true)};
    EXPECT_NE(scatterSvg(plot).find(">0</text>"), std::string::npos);
}

TEST(Scatter, NoPointsIsAPlotAllTheSame) {
    const std::string svg = scatterSvg({"empty", "x", "y", Scale::log, Scale::linear, {}, {}});
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_EQ(countOf(svg, "<svg "), 1u);
}

}  // namespace
}  // namespace cleave::test
