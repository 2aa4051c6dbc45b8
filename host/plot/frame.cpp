#include "plot/frame.h"

#include <array>

#include "base/text.h"
#include "plot/escape.h"

namespace cleave {
namespace {

// Okabe and Ito's colours, which remain distinct to the colour-blind; grey in place of their yellow, which is too pale
// for an outline on white.
constexpr std::array kColours{"#0072B2", "#000000", "#D55E00", "#E69F00", "#CC79A7", "#009E73", "#56B4E9", "#777777"};

constexpr double kLeastTickDistance = 16.0;
constexpr const char* kGrid = "stroke=\"#e3e3e3\"";
constexpr const char* kZero = "stroke=\"#9a9a9a\"";
constexpr const char* kAxis = "stroke=\"#1a1a1a\"";

std::string xTicks(const Axis& axis) {
    std::string out;
    for (const Tick& tick : axis.ticks()) {
        const double at = kPlotLeft + tick.at * (kPlotRight - kPlotLeft);
        out += lineSvg(at, kPlotTop, at, kPlotBottom, kGrid) + textSvg(at, kPlotBottom + 16.0, "middle", tick.label);
    }
    return out;
}

std::string yTicks(const Axis& axis) {
    std::string out;
    double below = kPlotBottom + kLeastTickDistance;
    for (const Tick& tick : axis.ticks()) {
        const double at = kPlotBottom - tick.at * (kPlotBottom - kPlotTop);
        if (below - at < kLeastTickDistance) continue;
        below = at;
        out += lineSvg(kPlotLeft, at, kPlotRight, at, tick.value == 0.0 ? kZero : kGrid) +
               textSvg(kPlotLeft - 7.0, at + 4.0, "end", tick.label);
    }
    return out;
}

}  // namespace

std::string svgOf(const std::string& title, const std::string& body) {
    const std::string width = fixed(kPlotWidth, 0), height = fixed(kPlotHeight, 0);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" viewBox=\"0 0 " + width + " " +
           height + "\" font-family=\"system-ui, Helvetica, Arial, sans-serif\" font-size=\"11\" fill=\"#1a1a1a\">\n" +
           "<title>" + escaped(title) + "</title>\n<rect width=\"" + width + "\" height=\"" + height +
           "\" fill=\"#fff\"/>\n" + body + "</svg>\n";
}

std::string axesSvg(const Axis& x, const Axis& y, const std::string& xTitle, const std::string& yTitle) {
    const double middle = 0.5 * (kPlotTop + kPlotBottom);
    return xTicks(x) + yTicks(y) + lineSvg(kPlotLeft, kPlotBottom, kPlotRight, kPlotBottom, kAxis) +
           lineSvg(kPlotLeft, kPlotTop, kPlotLeft, kPlotBottom, kAxis) +
           textSvg(0.5 * (kPlotLeft + kPlotRight), kPlotBottom + 38.0, "middle", xTitle, " font-size=\"12\"") +
           textSvg(16.0, middle, "middle", yTitle,
                   " font-size=\"12\" transform=\"rotate(-90 16 " + coordinate(middle) + ")\"");
}

const char* seriesColour(size_t series) { return kColours[series % kColours.size()]; }

std::string coordinate(double value) { return fixed(value, 1); }

std::string lineSvg(double x1, double y1, double x2, double y2, const char* look) {
    return "<line " + std::string(look) + " x1=\"" + coordinate(x1) + "\" y1=\"" + coordinate(y1) + "\" x2=\"" +
           coordinate(x2) + "\" y2=\"" + coordinate(y2) + "\"/>\n";
}

std::string textSvg(double x, double y, const char* anchor, const std::string& content, const std::string& more) {
    return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
           escaped(content) + "</text>\n";
}

}  // namespace cleave
