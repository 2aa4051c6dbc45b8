#include "figures/report_plots.h"

#include <algorithm>
#include <cmath>

#include "figures/picture_rows.h"
#include "figures/report_text.h"
#include "plot/curves.h"
#include "plot/scatter.h"
#include "plot/trend.h"

namespace cleave {
namespace {

// Above this error, in per cent or per million, a linear axis would press all small ones to one line.
constexpr double kLargestLinear = 50.0;

// `seriesOf` gives what a row is coloured by, `labelOf` what is written beside it.
template <class SeriesOf, class LabelOf>
std::string plotOf(const std::vector<ErrorRow>& rows, const std::string& title, const std::string& xTitle,
                   const std::string& yTitle, SeriesOf seriesOf, LabelOf labelOf) {
    ScatterPlot plot{title, xTitle, yTitle, Scale::log, Scale::linear, {}, {}};
    for (const ErrorRow& row : rows) {
        const std::string name = seriesOf(row);
        const auto found = std::find(plot.series.begin(), plot.series.end(), name);
        const auto series = static_cast<size_t>(found - plot.series.begin());
        if (found == plot.series.end()) plot.series.push_back(name);
        plot.points.push_back({series, row.time.median, row.error, row.time.low, row.time.high, row.errorLow,
                               row.errorHigh, labelOf(row), row.pareto});
        if (std::max(std::abs(row.errorLow), std::abs(row.errorHigh)) > kLargestLinear) plot.yScale = Scale::signedLog;
    }
    if (plot.yScale == Scale::signedLog) plot.yTitle += ", logarithmic above 1";
    return scatterSvg(plot);
}

std::string builderOf(const ErrorRow& row) { return row.builder; }
std::string labelOf(const ErrorRow& row) { return row.settings == kDefaultSettings ? row.builder : row.settings; }

std::vector<double> sharesOf(const std::vector<uint64_t>& counts) {
    double sum = 0.0;
    for (const uint64_t count : counts) sum += static_cast<double>(count);
    std::vector<double> shares;
    for (const uint64_t count : counts) shares.push_back(100.0 * static_cast<double>(count) / std::max(sum, 1.0));
    while (!shares.empty() && shares.back() == 0.0) shares.pop_back();
    return shares;
}

CurvePlot sharesPlot(const SceneErrors& scene, std::vector<uint64_t> TreeErrors::*histogram) {
    CurvePlot plot;
    plot.yTitle = "leaves, %";
    for (const TreeErrors& tree : scene.trees)
        if (tree.settings == kDefaultSettings) plot.curves.push_back({tree.builder, sharesOf(tree.*histogram)});
    return plot;
}

}  // namespace

std::string treePlot(const SceneErrors& scene) {
    return plotOf(treeRows(scene), scene.name + ": SAH cost above exact's against build time", "build time, ms",
                  "SAH cost above exact's, %", builderOf, labelOf);
}

std::string rayPlot(const SceneErrors& scene) {
    return plotOf(rayRows(scene), scene.name + ": tracing time above that through exact's tree against build time",
                  "build time, ms", "tracing time above exact's, %", builderOf, labelOf);
}

std::string hitPlot(const SceneErrors& scene) {
    std::vector<ErrorRow> rows = hitRows(scene);
    for (size_t i = 0; i < rows.size(); ++i) {
        rows[i].builder = scene.ways[i].test;
        rows[i].settings = scene.ways[i].traversal;
    }
    return plotOf(rows, scene.name + ": wrong answers per million rays against tracing time", "time of all rays, ms",
                  "wrong answers per million", builderOf, labelOf);
}

std::string pathPlot(const SceneErrors& scene) {
    TrendPlot plot;
    plot.title = scene.name + ": error of pictures against rendering time";
    plot.xTitle = "rendering time, ms";
    plot.yTitle = "error, % of the mean brightness";
    plot.series = {"samples of a pixel"};
    const std::vector<ErrorRow> rows = pictureRows(scene);
    for (size_t i = 0; i < rows.size(); ++i)
        if (rows[i].errorLow > 0.0)
            plot.points.push_back({0, rows[i].time.median, rows[i].error, rows[i].time.low, rows[i].time.high,
                                   rows[i].errorLow, rows[i].errorHigh,
                                   std::to_string(scene.paths.pictures[i].samples)});
    const LogPoints points = errorsByTime(scene);
    if (const std::optional<double> slope = logSlope({&points, 1}); slope && !plot.points.empty()) {
        const LogPoint centre = centreOf(points);
        plot.lines = {{"fitted, slope " + signedText(*slope, 3), *slope, centre.x, centre.y},
                      {"slope " + signedText(-0.5, 1), -0.5, centre.x, centre.y}};
        if (scene.paths.referenceError > 0.0)
            plot.lines.push_back({"the reference\u2019s own", 0.0, centre.x, scene.paths.referenceError});
    }
    return plot.points.empty() ? "" : trendSvg(plot);
}

std::string leafPlot(const SceneErrors& scene) {
    CurvePlot plot = sharesPlot(scene, &TreeErrors::leafHistogram);
    plot.title = scene.name + ": leaves by their number of triangles";
    plot.xTitle = "triangles in a leaf";
    for (const TreeErrors& tree : scene.trees)
        plot.openEnd = plot.openEnd || (!tree.leafHistogram.empty() && tree.leafHistogram.back() > 0);
    return curvesSvg(plot);
}

std::string depthPlot(const SceneErrors& scene) {
    CurvePlot plot = sharesPlot(scene, &TreeErrors::depthHistogram);
    plot.title = scene.name + ": leaves by their depth";
    plot.xTitle = "depth of a leaf";
    return curvesSvg(plot);
}

std::vector<NamedPlot> plotsOf(const SceneErrors& scene) {
    std::vector<NamedPlot> all{{"tree", treePlot(scene)},
                               {"rays", rayPlot(scene)},
                               {"hits", hitPlot(scene)},
                               {"leaves", leafPlot(scene)},
                               {"depths", depthPlot(scene)}};
    if (const std::string paths = pathPlot(scene); !paths.empty()) all.push_back({"paths", paths});
    return all;
}

}  // namespace cleave
