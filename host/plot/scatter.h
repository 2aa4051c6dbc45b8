// A scatter plot as SVG within HTML: text that depends on its data alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plot/frame.h"

namespace cleave {

struct PlotPoint {
    size_t series = 0;
    double x = 0.0, y = 0.0;
    double xLow = 0.0, xHigh = 0.0;  // the spread, drawn as a bar where it is wider than the mark
    double yLow = 0.0, yHigh = 0.0;
    std::string label;
    bool onFront = false;
};

struct ScatterPlot {
    std::string title;  // for those who do not see it
    std::string xTitle, yTitle;
    Scale xScale = Scale::log, yScale = Scale::linear;
    std::vector<std::string> series;  // names, for the legend
    std::vector<PlotPoint> points;
};

// An <svg> element. Series differ in colour and in shape. Points on the front are filled, and a staircase joins them:
// above it there is always one that is better. A label that has no free place beside its point is left out; every
// point tells its label and values as a title.
std::string scatterSvg(const ScatterPlot& plot);

}  // namespace cleave
