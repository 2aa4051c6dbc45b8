#include "plot/curves.h"

#include <gtest/gtest.h>

#include "plot/count_of.h"

namespace cleave::test {
namespace {

// x from 0 to 10 with margins of 5 %: 11 units over 546; y from 0 to 100, 110 over 352.
CurvePlot linear() {
    CurvePlot plot;
    plot.yScale = Scale::linear;
    plot.curves = {{"one", {100, 50, 0, 25, 0, 0, 0, 0, 0, 0, 1}}};
    return plot;
}

TEST(Curves, AreStaircasesWithGapsWhereNothingIs) {
    const std::string svg = curvesSvg(linear());
    // From half a number before to half a number after: 64 + 546 (x + 0.5) / 11, and 366 - 352 (y + 5) / 110.
    EXPECT_NE(svg.find("d=\"M64.0 30.0H113.6V190.0H163.3M212.9 270.0H262.5M"), std::string::npos) << svg;
}

TEST(Curves, OnALogarithmicScaleNeedNoZero) {
    CurvePlot plot = linear();
    plot.yScale = Scale::log;
    const std::string svg = curvesSvg(plot);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_NE(svg.find("M64.0 30.0H"), std::string::npos) << "100 is the upper end, less the margin\n" << svg;
}

TEST(Curves, EachHasItsLookAndItsNameInTheLegend) {
    CurvePlot plot = linear();
    plot.curves.push_back({"<two>", {1, 1, 1}});
    const std::string svg = curvesSvg(plot);
    EXPECT_EQ(countOf(svg, "&lt;two&gt;"), 2u) << "in the legend and as the curve's title";
    EXPECT_EQ(svg.find("<two>"), std::string::npos);
    EXPECT_EQ(countOf(svg, "stroke=\"#0072B2\""), 2u);
    EXPECT_EQ(countOf(svg, "stroke-dasharray=\"7 3\""), 2u);
    EXPECT_EQ(svg, curvesSvg(plot)) << "the same data, the same text";
}

TEST(Curves, NoneIsAPlotAllTheSame) {
    const std::string svg = curvesSvg({});
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(countOf(svg, "</svg>"), 1u);
}

TEST(Curves, SayWhereTheLastStepIsOpen) {
    CurvePlot plot = linear();
    EXPECT_EQ(curvesSvg(plot).find("or more"), std::string::npos);
    plot.openEnd = true;
    EXPECT_NE(curvesSvg(plot).find("or more"), std::string::npos);
}

}  // namespace
}  // namespace cleave::test
