#include "plot/trend.h"

#include <gtest/gtest.h>

#include "plot/count_of.h"

namespace cleave::test {
namespace {

// x from 1 to 100 and y from 10 down to 1, each two decades or one with margins of 5 %.
TrendPlot halving() {
    TrendPlot plot;
    plot.series = {"<of> pixels"};
    plot.points = {{0, 1, 10, 1, 1, 10, 10, "four"}, {0, 100, 1, 100, 100, 1, 1, "most"}};
    plot.lines = {{"slope", -0.5, 10.0, 3.1622776601683795}};
    return plot;
}

// 64 + 546 (0.1 + log x) / 2.2 and 366 - 352 (0.05 + log y) / 1.1.
TEST(Trend, PowersAreStraightLinesThroughTheirPoints) {
    const std::string svg = trendSvg(halving());
    for (const char* part :
         {"cx=\"88.8\" cy=\"30.0\"", "cx=\"585.2\" cy=\"350.0\"", "x1=\"88.8\" y1=\"30.0\" x2=\"585.2\" y2=\"350.0\""})
        EXPECT_NE(svg.find(part), std::string::npos) << part << " in\n" << svg;
}

TEST(Trend, ShowsTheWholeOfItsLines) {
    TrendPlot plot = halving();
    plot.lines.push_back({"far below", 0.0, 1.0, 0.1});
    const std::string svg = trendSvg(plot);
    EXPECT_NE(svg.find("x1=\"88.8\" y1=\"350.0\" x2=\"585.2\" y2=\"350.0\""), std::string::npos)
        << "one decade further down, where the margin ends\n"
        << svg;
}

TEST(Trend, NamesAreText) {
    const std::string svg = trendSvg(halving());
    EXPECT_EQ(svg.find("<of>"), std::string::npos);
    EXPECT_EQ(countOf(svg, "&lt;of&gt; pixels"), 2u) << "in the legend and as the title of its mark";
    EXPECT_EQ(countOf(svg, ">four<"), 1u);
    EXPECT_EQ(svg, trendSvg(halving()));
}

}  // namespace
}  // namespace cleave::test
