#include "plot/trend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "plot/escape.h"

namespace cleave {
namespace {

constexpr std::array kLooks{"stroke=\"#1a1a1a\" stroke-width=\"1.4\"",
                            "stroke=\"#777\" stroke-width=\"1.4\" stroke-dasharray=\"7 4\"",
                            "stroke=\"#777\" stroke-width=\"1.4\" stroke-dasharray=\"2 3\""};
constexpr const char* kSpread = "stroke=\"#8a8a8a\" stroke-width=\"1.2\"";

double valueAt(const TrendLine& line, double x) { return line.y * std::pow(x / line.x, line.slope); }

struct Span {
    double low, high;
    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

class Drawing {
  public:
    explicit Drawing(const TrendPlot& plot)
        : plot_(plot),
          across_(spanAcross()),
          xAxis_(Scale::log, across_.low, across_.high),
          yAxis_(Scale::log, spanUp().low, spanUp().high) {}

    std::string svg() const {
        std::string body = axesSvg(xAxis_, yAxis_, plot_.xTitle, plot_.yTitle);
        for (size_t i = 0; i < plot_.lines.size(); ++i) body += drawn(plot_.lines[i], kLooks[i % kLooks.size()]);
        for (const TrendPoint& point : plot_.points) body += drawn(point);
        return svgOf(plot_.title, body + legend());
    }

  private:
    const TrendPlot& plot_;
    const Span across_;
    Axis xAxis_, yAxis_;

    Span spanAcross() const {
        Span span{plot_.points.front().xLow, plot_.points.front().xHigh};
        for (const TrendPoint& p : plot_.points) {
            span.include(p.xLow);
            span.include(p.xHigh);
        }
        return span;
    }
    Span spanUp() const {
        Span span{plot_.points.front().yLow, plot_.points.front().yHigh};
        for (const TrendPoint& p : plot_.points) {
            span.include(p.yLow);
            span.include(p.yHigh);
        }
        for (const TrendLine& line : plot_.lines)
            for (const double x : {across_.low, across_.high}) span.include(valueAt(line, x));
        return span;
    }
    double x(double value) const { return kPlotLeft + xAxis_.at(value) * (kPlotRight - kPlotLeft); }
    double y(double value) const { return kPlotBottom - yAxis_.at(value) * (kPlotBottom - kPlotTop); }

    std::string drawn(const TrendLine& line, const char* look) const {
        return lineSvg(x(across_.low), y(valueAt(line, across_.low)), x(across_.high), y(valueAt(line, across_.high)),
                       look);
    }

    std::string drawn(const TrendPoint& p) const {
        return lineSvg(x(p.xLow), y(p.y), x(p.xHigh), y(p.y), kSpread) +
               lineSvg(x(p.x), y(p.yLow), x(p.x), y(p.yHigh), kSpread) +
               dot(p.series, x(p.x), y(p.y), p.label + ": " + fixed(p.x, 3) + ", " + fixed(p.y, 3)) +
               textSvg(x(p.x) + 7.0, y(p.y) - 7.0, "start", p.label);
    }

    std::string dot(size_t series, double atX, double atY, const std::string& title) const {
        return "<circle cx=\"" + coordinate(atX) + "\" cy=\"" + coordinate(atY) + "\" r=\"4.5\" fill=\"" +
               seriesColour(series) + "\"><title>" + escaped(title) + "</title></circle>\n";
    }

    std::string legend() const {
        std::string out;
        double at = kPlotTop + 10.0;
        for (size_t i = 0; i < plot_.series.size(); ++i, at += 20.0)
            out += dot(i, kPlotRight + 22.0, at, plot_.series[i]) +
                   textSvg(kPlotRight + 36.0, at + 4.0, "start", plot_.series[i]);
        for (size_t i = 0; i < plot_.lines.size(); ++i, at += 20.0)
            out += lineSvg(kPlotRight + 12.0, at, kPlotRight + 32.0, at, kLooks[i % kLooks.size()]) +
                   textSvg(kPlotRight + 36.0, at + 4.0, "start", plot_.lines[i].name);
        return out + textSvg(kPlotRight + 12.0, at + 12.0, "start", "bars: lowest to highest");
    }
};

}  // namespace

std::string trendSvg(const TrendPlot& plot) { return Drawing(plot).svg(); }

}  // namespace cleave
