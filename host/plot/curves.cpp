#include "plot/curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "plot/escape.h"

namespace cleave {
namespace {

// Curves that lie on each other are told apart by their dashes.
constexpr std::array kDashes{"", "7 3", "2 2", "9 2 2 2"};

class Drawing {
  public:
    explicit Drawing(const CurvePlot& plot)
        : plot_(plot), xAxis_(Scale::linear, 0.0, last()), yAxis_(plot.yScale, least(), most()) {}

    std::string svg() const {
        std::string body = axesSvg(xAxis_, yAxis_, plot_.xTitle, plot_.yTitle);
        for (size_t i = 0; i < plot_.curves.size(); ++i) body += staircase(i) + nameInLegend(i);
        if (plot_.openEnd)
            body += textSvg(kPlotRight + 14.0, kPlotTop + 18.0 + 20.0 * static_cast<double>(plot_.curves.size()),
                            "start", "right end: or more");
        return svgOf(plot_.title, body);
    }

  private:
    const CurvePlot& plot_;
    Axis xAxis_, yAxis_;

    double last() const {
        size_t size = 1;
        for (const Curve& curve : plot_.curves) size = std::max(size, curve.values.size());
        return static_cast<double>(size - 1);
    }
    double most() const {
        double found = 0.0;
        for (const Curve& curve : plot_.curves)
            for (const double value : curve.values) found = std::max(found, value);
        return found > 0.0 ? found : 1.0;
    }
    double least() const {
        if (plot_.yScale == Scale::linear) return 0.0;
        double found = most();
        for (const Curve& curve : plot_.curves)
            for (const double value : curve.values)
                if (value > 0.0) found = std::min(found, value);
        return found;
    }
    double x(double value) const { return kPlotLeft + xAxis_.at(value) * (kPlotRight - kPlotLeft); }
    double y(double value) const { return kPlotBottom - yAxis_.at(value) * (kPlotBottom - kPlotTop); }

    std::string look(size_t i) const {
        const std::string dashes = kDashes[i % kDashes.size()];
        return "fill=\"none\" stroke=\"" + std::string(seriesColour(i)) + "\" stroke-width=\"1.6\"" +
               (dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"");
    }

    // A value is drawn from half a number before its own to half a number after it.
    std::string staircase(size_t i) const {
        const Curve& curve = plot_.curves[i];
        std::string path;
        bool drawing = false;
        for (size_t n = 0; n < curve.values.size(); ++n) {
            const double value = curve.values[n], at = static_cast<double>(n);
            if (!(value > 0.0)) {
                drawing = false;
                continue;
            }
            path += (drawing ? "V" : "M" + coordinate(x(at - 0.5)) + " ") + coordinate(y(value)) + "H" +
                    coordinate(x(at + 0.5));
            drawing = true;
        }
        if (path.empty()) return "";
        return "<path " + look(i) + " d=\"" + path + "\"><title>" + escaped(curve.name) + "</title></path>\n";
    }

    std::string nameInLegend(size_t i) const {
        const double at = kPlotTop + 10.0 + 20.0 * static_cast<double>(i);
        return "<path " + look(i) + " d=\"M" + coordinate(kPlotRight + 14.0) + " " + coordinate(at) + "h22\"/>\n" +
               textSvg(kPlotRight + 42.0, at + 4.0, "start", plot_.curves[i].name);
    }
};

}  // namespace

std::string curvesSvg(const CurvePlot& plot) { return Drawing(plot).svg(); }

}  // namespace cleave
