// A plot of distributions as SVG within HTML: a staircase for each over the whole numbers.
#pragma once

#include <string>
#include <vector>

#include "plot/frame.h"

namespace cleave {

struct Curve {
    std::string name;
    std::vector<double> values;  // at 0, 1, 2, ...; what is not above 0 is not drawn
};

struct CurvePlot {
    std::string title;  // for those who do not see it
    std::string xTitle, yTitle;
    Scale yScale = Scale::log;
    std::vector<Curve> curves;
    bool openEnd = false;  // the last value is of its number and of all beyond it
};

// An <svg> element: the same text for the same data.
std::string curvesSvg(const CurvePlot& plot);

}  // namespace cleave
