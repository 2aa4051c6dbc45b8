#include "figures/report_page.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/text.h"
#include "plot/escape.h"
#include "plot/scatter.h"

namespace cleave {
namespace {

// Above this error, in per cent or per million, a linear axis would press all small ones to one line.
constexpr double kLargestLinear = 50.0;

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { max-width: 58rem; margin: 2rem auto 4rem; padding: 0 1.2rem; color: #1a1a1a; background: #fff;
  font: 1rem/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.35rem; margin: 2.8rem 0 .4rem; padding-top: .8rem; border-top: 2px solid #1a1a1a; overflow-wrap: anywhere; }
h3 { font-size: 1.08rem; margin: 2rem 0 .3rem; }
p { margin: .4rem 0 .8rem; max-width: 46rem; }
code { font: .9em ui-monospace, "DejaVu Sans Mono", Menlo, monospace; overflow-wrap: anywhere; }
.plot { display: block; width: 100%; height: auto; margin: .6rem 0; font-family: inherit; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: .6rem 0 1rem; font-size: .86rem; line-height: 1.35; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding-bottom: .3rem; }
th, td { padding: .18rem .7rem .18rem 0; text-align: left; vertical-align: top; }
th { border-bottom: 1px solid #1a1a1a; font-weight: 600; }
td { border-bottom: 1px solid #e6e6e6; }
.n { text-align: right; } .n, .s { white-space: nowrap; }
.best { font-weight: 700; }
.failure { border-left: 4px solid #D55E00; padding-left: .8rem; overflow-wrap: anywhere; }
@media print { body { max-width: none; margin: 0; font-size: 9.5pt; } h3, .plot, tr { break-inside: avoid; }
  h3 { break-after: avoid; } .wide { overflow: visible; } a { color: inherit; text-decoration: none; } }
)";

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

// A cell of a table. What begins with a mark is the best of its column.
using Row = std::vector<std::string>;
constexpr size_t kShort = 24;  // no break in a cell of fewer bytes
constexpr const char* kBest = "\u2605 ";

// The first row is the head. `alignment` has a letter per column, l or r.
std::string table(const std::string& caption, const std::vector<Row>& rows, std::string_view alignment) {
    std::string html = "<div class=\"wide\"><table>\n<caption>" + escaped(caption) + "</caption>\n";
    for (size_t i = 0; i < rows.size(); ++i) {
        html += i == 0 ? "<thead><tr>" : "<tr>";
        const char* tag = i == 0 ? "th" : "td";
        for (size_t column = 0; column < rows[i].size(); ++column) {
            const std::string& cell = rows[i][column];
            std::string kind = alignment[column] == 'r' ? "n" : cell.size() < kShort ? "s" : "";
            if (cell.starts_with(kBest)) kind += kind.empty() ? "best" : " best";
            html += "<" + std::string(tag) + (i == 0 ? " scope=\"col\"" : "") +
                    (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + escaped(cell) + "</" + tag + ">";
        }
        html += i == 0 ? "</tr></thead>\n<tbody>\n" : "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string milliseconds(double ms) { return fixed(ms, ms < 10.0 ? 3 : ms < 1000.0 ? 1 : 0); }

std::string rangeOf(const Spread& s) { return milliseconds(s.low) + "\u2013" + milliseconds(s.high); }

std::string median(const Spread& s) { return s.runs == 0 ? "-" : milliseconds(s.median); }

std::string signedText(double value, int digits) {
    return value < 0.0 ? "\u2212" + fixed(-value, digits) : fixed(value, digits);
}

std::string errorText(double error) { return signedText(error, std::abs(error) < 10.0 ? 2 : 1); }

std::vector<ErrorRow> byTime(std::vector<ErrorRow> rows) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const ErrorRow& a, const ErrorRow& b) { return a.time.median < b.time.median; });
    return rows;
}

bool isDefault(const ErrorRow& row) { return row.settings == "defaults"; }

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

std::string treeSection(const SceneErrors& scene) {
    std::string html = "<h3>Tree: cost above that of <code>exact</code>, against build time</h3>\n" +
                       paragraph(
                           "Error: by how many per cent the tree\u2019s expected cost by the surface area "
                           "heuristic is above that of <code>exact</code>, which tries every plane; being greedy, it "
                           "can be beaten. Time: from "
                           "triangles in memory, or on the device, to a tree ready to trace; warm.");
    html += plotOf(scene.tree, scene.name + ": SAH cost above exact's against build time", "build time, ms",
                   "SAH cost above exact's, %", builderOf,
                   [](const ErrorRow& row) { return isDefault(row) ? row.builder : row.settings; });
    std::vector<Row> rows{{"builder", "settings", "error, %", "ms", "low\u2013high", "runs", "front"}};
    for (const ErrorRow& row : byTime(scene.tree))
        rows.push_back({row.builder, row.settings, errorText(row.error), median(row.time), rangeOf(row.time),
                        std::to_string(row.time.runs), row.pareto ? "\u25CF" : ""});
    html += table("Trees of " + scene.name + ", by build time", rows, "llrrrrl");
    for (const std::string& builder : scene.withoutCost)
        html += paragraph("No row for <code>" + escaped(builder) +
                          "</code>: the box of its tree has no area, so no cost is defined.");
    return html;
}

// Build and k traces. A spread of sums is the sum of the ends.
Spread timeToImage(const RayTimes& times, double k) {
    return {times.build.median + k * times.all.median, times.build.low + k * times.all.low,
            times.build.high + k * times.all.high, times.build.runs};
}

std::string imageTable(const SceneErrors& scene) {
    constexpr std::array kTraces{1, 10, 100, 1000};
    std::vector<Row> rows{{"builder"}};
    for (const RayTimes& times : scene.rayTimes) rows.push_back({times.builder});
    std::string alignment = "l";
    for (const int k : kTraces) {
        rows[0].push_back("k = " + grouped(static_cast<uint64_t>(k)));
        alignment += 'r';
        std::vector<Spread> sums;
        for (const RayTimes& times : scene.rayTimes) sums.push_back(timeToImage(times, k));
        const auto best = std::min_element(sums.begin(), sums.end(),
                                           [](const Spread& a, const Spread& b) { return a.median < b.median; });
        for (size_t i = 0; i < sums.size(); ++i) {
            const bool isBest = sums.begin() + static_cast<ptrdiff_t>(i) == best;
            rows[i + 1].push_back((isBest                      ? kBest
                                   : sums[i].low <= best->high ? "\u2248 "
                                                               : "") +
                                  milliseconds(sums[i].median) + " (" + rangeOf(sums[i]) + ")");
        }
    }
    return table("Time to image: build + k \u00D7 trace of all sets, ms (low\u2013high)", rows, alignment) +
           paragraph("\u2605 is the least of its column; \u2248 may be as quick, for the spreads touch.");
}

std::string raySection(const SceneErrors& scene, const ReportPage& page) {
    std::string html =
        "<h3>Rays: tracing time above that through the tree of <code>exact</code>, against build time</h3>\n" +
        paragraph("Error: by how many per cent all sets of rays (primary, diffuse and shadow, up to " +
                  grouped(page.raysOfSet) +
                  " each) take longer than through the tree of <code>exact</code>, by the "
                  "same traversal (" +
                  escaped(page.traversal) +
                  "). Below 0 they take less. The error\u2019s bar is that "
                  "of the tracing times over exact\u2019s median.");
    html += plotOf(scene.rays, scene.name + ": tracing time above that through exact's tree against build time",
                   "build time, ms", "tracing time above exact's, %", builderOf, builderOf);
    std::vector<Row> rows{{"builder", "error, %", "low\u2013high", "build ms", "low\u2013high", "runs", "front"}};
    std::vector<Row> sets{{"builder"}};
    for (const char* name : kRaySets) sets[0].insert(sets[0].end(), {std::string(name) + " ms", "low\u2013high"});
    sets[0].push_back("runs");
    for (size_t i = 0; i < scene.rays.size(); ++i) {
        const ErrorRow& row = scene.rays[i];
        rows.push_back({row.builder, errorText(row.error), errorText(row.errorLow) + " to " + errorText(row.errorHigh),
                        median(row.time), rangeOf(row.time), std::to_string(row.time.runs),
                        row.pareto ? "\u25CF" : ""});
        sets.push_back({row.builder});
        for (const Spread& set : scene.rayTimes[i].sets)
            sets.back().insert(sets.back().end(), {median(set), set.runs == 0 ? "-" : rangeOf(set)});
        sets.back().push_back(std::to_string(scene.rayTimes[i].all.runs));
    }
    return html + table("Rays through the trees of " + scene.name, rows, "lrrrrrl") +
           table("The same by the set of rays: tracing times", sets, "lrrrrrrr") + imageTable(scene);
}

std::string hitSection(const SceneErrors& scene) {
    std::string html =
        "<h3>Hits: wrong answers, against tracing time</h3>\n" +
        paragraph(
            "Error: answers that the independent reference finds wrong, per million rays that it judged. Time: of "
            "all sets of rays, through the tree of <code>gpu</code>. The tests <code>watertight</code> and "
            "<code>unfiltered</code> have to be right, or there would be no figures here; <code>plain</code> is "
            "M\u00F6ller and Trumbore\u2019s in float. With no wrong answer among n, the true share is below 3/n "
            "at a confidence of 95 %.");
    html += plotOf(
        scene.hits, scene.name + ": wrong answers per million rays against tracing time", "time of all rays, ms",
        "wrong answers per million",
        [](const ErrorRow& row) { return row.settings.substr(row.settings.find(", ") + 2); },
        [](const ErrorRow& row) { return row.settings.substr(0, row.settings.find(", ")); });
    std::vector<Row> rows{{"traversal, triangle test", "wrong per million", "wrong", "judged", "undecided", "ms",
                           "low\u2013high", "Mrays/s", "runs", "front"}};
    for (size_t i = 0; i < scene.hits.size(); ++i) {
        const ErrorRow& row = scene.hits[i];
        const JudgedRays& rays = scene.judged[i];
        rows.push_back({row.settings, errorText(row.error), grouped(rays.wrong), grouped(rays.judged),
                        grouped(rays.undecided), median(row.time), rangeOf(row.time),
                        fixed(mraysPerSecond(rays.traced, row.time.median), 2), std::to_string(row.time.runs),
                        row.pareto ? "\u25CF" : ""});
    }
    return html + table("Ways to answer rays in " + scene.name, rows, "lrrrrrrrrl");
}

std::string rateText(const PeerSetFigures& set) {
    if (set.runs.empty()) return "-";
    const Spread s = spreadOf(set.runs);
    return fixed(mraysPerSecond(set.rays, s.median), 2) + " (" + fixed(mraysPerSecond(set.rays, s.high), 2) + "\u2013" +
           fixed(mraysPerSecond(set.rays, s.low), 2) + ")";
}

std::string peerSection(const SceneErrors& scene) {
    std::vector<Row> rows{{"ray tracer", "triangle order", "build ms", "low\u2013high", "primary Mrays/s",
                           "diffuse Mrays/s", "shadow Mrays/s", "rays", "differing"}};
    for (const PeerFigures& peer : scene.peers) {
        if (!peer.missing.empty()) {
            rows.push_back({peer.name, peer.order, "missing: " + peer.missing, "", "", "", "", "", ""});
            continue;
        }
        const Spread build = spreadOf(peer.buildRuns);
        rows.push_back({peer.name, peer.order, median(build), rangeOf(build)});
        uint64_t rays = 0, differing = 0;
        for (const PeerSetFigures& set : peer.sets) {
            rows.back().push_back(set.isWrong() ? "wrong" : rateText(set));
            rays += set.rays;
            differing += set.disagreements;
        }
        rows.back().insert(rows.back().end(), {grouped(rays), grouped(differing)});
    }
    return "<h3>Other ray tracers on the same rays</h3>\n" +
           paragraph(
               "Each computes in float, so a few answers about rays that graze an edge differ from ours. Slow ones "
               "are given a sample of the rays.") +
           table("Peers in " + scene.name, rows, "llrrrrrrr");
}

std::string sceneSection(const SceneErrors& scene, const ReportPage& page) {
    std::string html = "<h2>" + escaped(scene.name) + "</h2>\n";
    if (!scene.failure.empty()) return html + "<p class=\"failure\">No figures: " + escaped(scene.failure) + "</p>\n";
    html += paragraph(grouped(scene.triangles) + " triangles.");
    html += treeSection(scene) + raySection(scene, page) + hitSection(scene);
    if (page.withPeers) html += peerSection(scene);
    return html;
}

}  // namespace

std::string reportHtml(const ReportPage& page) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>cleave: error against run time</title>\n<style>" +
        std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>Error against run time</h1>\n";
    html += paragraph(
        "What more time buys: how far each tree is from that of the builder <code>exact</code>, and each answer "
        "to a ray from the right one, against what it took. Below and to the left is better. A point is on the Pareto "
        "front, "
        "filled and joined by the dashed line, if none of the same scene is at most as large in both and "
        "smaller in one. Times are medians; their spread, lowest to highest of the runs, is beside each.");
    html += table("How it was measured",
                  {{"what", "value"},
                   {"device", page.device},
                   {"driver", page.driver},
                   {"program", "cleave " + page.version},
                   {"command line", page.commandLine},
                   {"runs", std::to_string(page.runs) + " of each, after a warm-up; rays in two turns, there and back"},
                   {"threads of CPU builders", std::to_string(page.threads)},
                   {"primary rays", page.interior ? "from inside, for rooms" : "from outside, the benchmark's camera"}},
                  "ll");
    for (const SceneErrors& scene : page.scenes) html += sceneSection(scene, page);
    std::vector<Row> rows{{"what", "why"}};
    for (const auto& [what, why] : page.leftOut) rows.push_back({what, why});
    html += "<h2>What was left out</h2>\n" + table("Not in this report", rows, "ll");
    return html + "</body>\n</html>\n";
}

}  // namespace cleave
