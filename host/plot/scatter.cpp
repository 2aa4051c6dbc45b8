#include "plot/scatter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "plot/escape.h"
#include "plot/frame.h"

namespace cleave {
namespace {

// Outlines about the origin.
constexpr std::array kShapes{"M-5 0A5 5 0 1 0 5 0A5 5 0 1 0-5 0Z",  // circle
                             "M-4.5-4.5H4.5V4.5H-4.5Z",             // square
                             "M0-6L5.5 4H-5.5Z",                    // triangle
                             "M0-6L6 0L0 6L-6 0Z",                  // diamond
                             "M0 6L5.5-4H-5.5Z"};                   // triangle on its tip
constexpr double kMark = 6.0;                                       // half of its size
constexpr double kCharacter = 6.2;                                  // width of one in a label, about
constexpr double kLabelHeight = 11.0;

struct Rectangle {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    bool overlaps(const Rectangle& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

constexpr const char* kSpread = "stroke=\"#8a8a8a\" stroke-width=\"1.2\"";
constexpr const char* kFront = "fill=\"none\" stroke=\"#555\" stroke-width=\"1.4\" stroke-dasharray=\"5 3\"";

std::string mark(size_t series, double x, double y, bool filled, const std::string& title) {
    const std::string colour = seriesColour(series);
    return "<path transform=\"translate(" + coordinate(x) + " " + coordinate(y) + ")\" d=\"" +
           kShapes[series % kShapes.size()] + "\" stroke=\"" + colour + "\" fill=\"" + (filled ? colour : "#fff") +
           "\" stroke-width=\"1.6\"" +
           (title.empty() ? std::string("/>\n") : "><title>" + escaped(title) + "</title></path>\n");
}

class Drawing {
  public:
    explicit Drawing(const ScatterPlot& plot)
        : plot_(plot),
          xAxis_(plot.xScale, least(&PlotPoint::xLow), most(&PlotPoint::xHigh)),
          yAxis_(plot.yScale, lowest(), highest()) {}

    std::string svg() const {
        return svgOf(plot_.title, axesSvg(xAxis_, yAxis_, plot_.xTitle, plot_.yTitle) + staircase() + spreads() +
                                      marks() + labels() + legend());
    }

  private:
    const ScatterPlot& plot_;
    Axis xAxis_, yAxis_;

    double least(double PlotPoint::*value) const {
        double found = plot_.points.empty() ? 1.0 : plot_.points.front().*value;
        for (const PlotPoint& p : plot_.points) found = std::min(found, p.*value);
        return found;
    }
    double most(double PlotPoint::*value) const {
        double found = plot_.points.empty() ? 1.0 : plot_.points.front().*value;
        for (const PlotPoint& p : plot_.points) found = std::max(found, p.*value);
        return found;
    }
    // Zero is always shown: an error is a distance from it. One unit is, where all are zero.
    double lowest() const { return std::min(0.0, least(&PlotPoint::yLow)); }
    double highest() const {
        const double found = std::max(0.0, most(&PlotPoint::yHigh));
        return found > lowest() ? found : lowest() + 1.0;
    }
    double x(double value) const { return kPlotLeft + xAxis_.at(value) * (kPlotRight - kPlotLeft); }
    double y(double value) const { return kPlotBottom - yAxis_.at(value) * (kPlotBottom - kPlotTop); }

    // By x.
    std::vector<const PlotPoint*> frontPoints() const {
        std::vector<const PlotPoint*> front;
        for (const PlotPoint& p : plot_.points)
            if (p.onFront) front.push_back(&p);
        std::stable_sort(front.begin(), front.end(),
                         [](const PlotPoint* a, const PlotPoint* b) { return a->x < b->x; });
        return front;
    }

    std::string staircase() const {
        const std::vector<const PlotPoint*> front = frontPoints();
        if (front.empty()) return "";
        std::string path = "M" + coordinate(x(front.front()->x)) + " " + coordinate(kPlotTop);
        for (const PlotPoint* p : front) path += "H" + coordinate(x(p->x)) + "V" + coordinate(y(p->y));
        return "<path " + std::string(kFront) + " d=\"" + path + "H" + coordinate(kPlotRight) + "\"/>\n";
    }

    std::string spreads() const {
        std::string out;
        for (const PlotPoint& p : plot_.points) {
            if (x(p.xHigh) - x(p.xLow) > kMark) out += lineSvg(x(p.xLow), y(p.y), x(p.xHigh), y(p.y), kSpread);
            if (y(p.yLow) - y(p.yHigh) > kMark) out += lineSvg(x(p.x), y(p.yLow), x(p.x), y(p.yHigh), kSpread);
        }
        return out;
    }

    std::string nameOf(const PlotPoint& p) const {
        return p.series < plot_.series.size() ? plot_.series[p.series] : "";
    }

    // Those on the front on top.
    std::string marks() const {
        std::string out;
        for (const bool front : {false, true})
            for (const PlotPoint& p : plot_.points)
                if (p.onFront == front)
                    out += mark(p.series, x(p.x), y(p.y), front,
                                nameOf(p) + ", " + p.label + ": " + fixed(p.x, 3) + ", " + fixed(p.y, 3));
        return out;
    }

    std::vector<Rectangle> taken() const {
        std::vector<Rectangle> all;
        for (const PlotPoint& p : plot_.points)
            all.push_back({x(p.x) - kMark, y(p.y) - kMark, x(p.x) + kMark, y(p.y) + kMark});
        return all;
    }

    // The lines that a label had better not cross: the staircase and the spreads.
    std::vector<Rectangle> lines() const {
        std::vector<Rectangle> all;
        double top = kPlotTop;
        const std::vector<const PlotPoint*> front = frontPoints();
        for (size_t i = 0; i < front.size(); ++i) {
            const double right = i + 1 < front.size() ? x(front[i + 1]->x) : kPlotRight;
            const double here = x(front[i]->x), bottom = y(front[i]->y);
            all.push_back({here - 1.0, top, here + 1.0, bottom});
            all.push_back({here, bottom - 1.0, right, bottom + 1.0});
            top = bottom;
        }
        for (const PlotPoint& p : plot_.points) {
            all.push_back({x(p.xLow), y(p.y) - 1.0, x(p.xHigh), y(p.y) + 1.0});
            all.push_back({x(p.x) - 1.0, y(p.yHigh), x(p.x) + 1.0, y(p.yLow)});
        }
        return all;
    }

    // Places are tried in turn, first those that no line crosses; points on the front choose first.
    std::string labels() const {
        std::vector<Rectangle> occupied = taken();
        const std::vector<Rectangle> crossing = lines();
        std::string out;
        for (const bool front : {true, false})
            for (const PlotPoint& p : plot_.points)
                if (p.onFront == front && !p.label.empty()) out += placed(p, occupied, crossing);
        return out;
    }

    std::string placed(const PlotPoint& p, std::vector<Rectangle>& occupied,
                       const std::vector<Rectangle>& crossing) const {
        struct Place {
            double dx, dy;  // of the label's anchor, from the point to the text's middle line
            const char* anchor;
        };
        constexpr std::array<Place, 8> kPlaces{{{9, 0, "start"},
                                                {-9, 0, "end"},
                                                {0, -14, "middle"},
                                                {0, 14, "middle"},
                                                {7, -11, "start"},
                                                {7, 11, "start"},
                                                {-7, -11, "end"},
                                                {-7, 11, "end"}}};
        const double width = kCharacter * static_cast<double>(p.label.size());
        for (const bool strict : {true, false})
            for (const Place& place : kPlaces) {
                const double at = x(p.x) + place.dx, middle = y(p.y) + place.dy;
                const double left = place.anchor[0] == 's'   ? at
                                    : place.anchor[0] == 'e' ? at - width
                                                             : at - 0.5 * width;
                const Rectangle box{left, middle - 0.5 * kLabelHeight, left + width, middle + 0.5 * kLabelHeight};
                const bool inside = box.left >= kPlotLeft && box.right <= kPlotRight && box.top >= kPlotTop &&
                                    box.bottom <= kPlotBottom;
                const auto meets = [&](const Rectangle& other) { return box.overlaps(other); };
                if (!inside || std::any_of(occupied.begin(), occupied.end(), meets)) continue;
                if (strict && std::any_of(crossing.begin(), crossing.end(), meets)) continue;
                occupied.push_back(box);
                return "<rect fill=\"#fff\" fill-opacity=\"0.8\" x=\"" + coordinate(box.left) + "\" y=\"" +
                       coordinate(box.top) + "\" width=\"" + coordinate(width) + "\" height=\"" +
                       coordinate(kLabelHeight) + "\"/>\n" + textSvg(at, middle + 4.0, place.anchor, p.label);
            }
        return "";
    }

    std::string legend() const {
        std::string out;
        double at = kPlotTop + 10.0;
        for (size_t i = 0; i < plot_.series.size(); ++i, at += 20.0)
            out += mark(i, kPlotRight + 22.0, at, true, "") +
                   textSvg(kPlotRight + 34.0, at + 4.0, "start", plot_.series[i]);
        at += 8.0;
        out += "<path " + std::string(kFront) + " d=\"M" + coordinate(kPlotRight + 14.0) + " " + coordinate(at) +
               "h16\"/>\n" + textSvg(kPlotRight + 34.0, at + 4.0, "start", "Pareto front");
        return out + textSvg(kPlotRight + 14.0, at + 24.0, "start", "filled: on the front") +
               textSvg(kPlotRight + 14.0, at + 40.0, "start", "bars: lowest to highest");
    }
};

}  // namespace

std::string scatterSvg(const ScatterPlot& plot) { return Drawing(plot).svg(); }

}  // namespace cleave
