// A plot of power laws as SVG within HTML: points in double logarithmic axes, and straight lines beside them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plot/frame.h"

namespace cleave {

// All values are above 0.
struct TrendPoint {
    size_t series = 0;
    double x = 0.0, y = 0.0;
    double xLow = 0.0, xHigh = 0.0;  // the spread
    double yLow = 0.0, yHigh = 0.0;
    std::string label;  // beside it
};

// y grows with the power `slope` of x, and (x, y) is on it. It is drawn as far as the points go.
struct TrendLine {
    std::string name;
    double slope = 0.0, x = 1.0, y = 1.0;
};

struct TrendPlot {
    std::string title;  // for those who do not see it
    std::string xTitle, yTitle;
    std::vector<std::string> series;  // names, for the legend
    std::vector<TrendPoint> points;   // at least one
    std::vector<TrendLine> lines;
};

// An <svg> element: the same text for the same data.
std::string trendSvg(const TrendPlot& plot);

}  // namespace cleave
