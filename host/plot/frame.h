// What all plots have: a picture of one size, axes with their grid and titles, colours of series.
#pragma once

#include <cstddef>
#include <string>

#include "plot/axis.h"

namespace cleave {

// The area within the axes, in the units of the picture, which is kPlotWidth x kPlotHeight. The legend is right of it.
inline constexpr double kPlotWidth = 760.0, kPlotHeight = 420.0;
inline constexpr double kPlotLeft = 64.0, kPlotRight = 610.0, kPlotTop = 14.0, kPlotBottom = 366.0;

// The whole picture, an <svg> element that stands in HTML or in a file of its own; `title` is for those who do not see
// it.
std::string svgOf(const std::string& title, const std::string& body);

// The grid, the axes and what is written beside them.
std::string axesSvg(const Axis& x, const Axis& y, const std::string& xTitle, const std::string& yTitle);

// Distinct for eight series, to the colour-blind, too.
const char* seriesColour(size_t series);

std::string coordinate(double value);
// `look`: attributes. A plot looks the same under any style sheet.
std::string lineSvg(double x1, double y1, double x2, double y2, const char* look);
std::string textSvg(double x, double y, const char* anchor, const std::string& content, const std::string& more = "");

}  // namespace cleave
