#include "figures/report_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "figures/error_rows.h"
#include "figures/html.h"
#include "figures/report_paths.h"
#include "figures/report_plots.h"
#include "figures/report_text.h"
#include "plot/escape.h"

namespace cleave {
namespace {

std::string treeSection(const SceneErrors& scene) {
    std::string html =
        headline("Tree: cost above that of <code>exact</code>, against build time") +
        paragraph(
            "Error: by how many per cent the tree\u2019s expected cost by the surface area heuristic is above that of "
            "<code>exact</code>, which tries every plane; being greedy, it can be beaten. The cost is taken with the "
            "same constants for every tree, whatever it was built with. Time: from triangles in memory, or on the "
            "device, to a tree ready to trace; warm.") +
        treePlot(scene);
    std::vector<ErrorRow> sorted = treeRows(scene);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const ErrorRow& a, const ErrorRow& b) { return a.time.median < b.time.median; });
    std::vector<HtmlRow> rows{{"builder", "settings", "error, %", "ms", "low\u2013high", "runs", "front"}};
    for (const ErrorRow& row : sorted)
        rows.push_back({row.builder, row.settings, errorText(row.error), medianText(row.time), rangeOf(row.time),
                        std::to_string(row.time.runs), frontMark(row)});
    html += htmlTable("Trees of " + scene.name + ", by build time", rows, "llrrrrl");
    for (const TreeErrors& tree : scene.trees)
        if (!tree.hasCost)
            html += paragraph("No row for <code>" + escaped(tree.builder) +
                              "</code>: the box of its tree has no area, so no cost is defined.");
    return html;
}

std::string nameOf(const TreeErrors& tree) {
    return tree.settings == kDefaultSettings ? tree.builder : tree.builder + ", " + tree.settings;
}

// Build and k traces. A spread of sums is the sum of the ends.
Spread timeToImage(const Spread& build, const Spread& trace, double k) {
    return {build.median + k * trace.median, build.low + k * trace.low, build.high + k * trace.high, build.runs};
}

std::string imageTable(const SceneErrors& scene) {
    constexpr std::array kTraces{1, 10, 100, 1000};
    std::vector<HtmlRow> rows{{"builder"}};
    for (const TracedErrors& traced : scene.traced) rows.push_back({nameOf(scene.trees[traced.tree])});
    std::string alignment = "l";
    for (const int k : kTraces) {
        rows[0].push_back("k = " + grouped(static_cast<uint64_t>(k)));
        alignment += 'r';
        std::vector<Spread> sums;
        for (const TracedErrors& traced : scene.traced)
            sums.push_back(timeToImage(spreadOrNone(scene.trees[traced.tree].runs), timeOfAll(traced.sets), k));
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
    return htmlTable("Time to image: build + k \u00D7 trace of all sets, ms (low\u2013high)", rows, alignment) +
           paragraph("\u2605 is the least of its column; \u2248 may be as quick, for the spreads touch.");
}

std::string raySection(const SceneErrors& scene, const ReportSettings& settings) {
    std::string html =
        headline("Rays: tracing time above that through the tree of <code>exact</code>, against build time") +
        paragraph("Error: by how many per cent all sets of rays (primary, diffuse and shadow, up to " +
                  grouped(settings.raysOfSet) +
                  " each) take longer than through the tree of <code>exact</code>, by the same traversal (" +
                  escaped(settings.traversal) +
                  "). Below 0 they take less. The error\u2019s bar is that of the tracing times over exact\u2019s "
                  "median. A sample of the answers through each tree was judged before its time was taken.") +
        rayPlot(scene);
    const std::vector<ErrorRow> errors = rayRows(scene);
    std::vector<HtmlRow> rows{{"builder", "error, %", "low\u2013high", "nodes per ray", "tests per ray", "build ms",
                               "low\u2013high", "runs", "front"}};
    std::vector<HtmlRow> sets{{"builder"}};
    for (const char* name : kRaySets) sets[0].insert(sets[0].end(), {std::string(name) + " ms", "low\u2013high"});
    sets[0].push_back("runs");
    for (size_t i = 0; i < errors.size(); ++i) {
        const ErrorRow& row = errors[i];
        const TracedErrors& traced = scene.traced[i];
        const RayCounts mean = meanCounts(traced);
        const std::string name = nameOf(scene.trees[traced.tree]);
        rows.push_back({name, errorText(row.error), errorText(row.errorLow) + " to " + errorText(row.errorHigh),
                        fixed(mean.inner + mean.leaves, 1), fixed(mean.triangles, 2), medianText(row.time),
                        rangeOf(row.time), std::to_string(row.time.runs), frontMark(row)});
        sets.push_back({name});
        for (const SetErrors& set : traced.sets) {
            const Spread spread = spreadOrNone(set.runs);
            sets.back().insert(sets.back().end(), {medianText(spread), rangeOf(spread)});
        }
        sets.back().push_back(std::to_string(timeOfAll(traced.sets).runs));
    }
    return html + htmlTable("Rays through the trees of " + scene.name, rows, "lrrrrrrrl") +
           htmlTable("The same by the set of rays: tracing times", sets, "lrrrrrrr") + imageTable(scene);
}

std::string hitSection(const SceneErrors& scene) {
    std::string html =
        headline("Hits: wrong answers, against tracing time") +
        paragraph(
            "Error: answers that the independent reference finds wrong, per million rays that it judged: a hit at a "
            "wrong distance or of a wrong triangle, a hit that was missed, or one where there is none. Time: of "
            "all sets of rays, through the tree of <code>gpu</code>. <code>watertight</code> and "
            "<code>unfiltered</code> are meant to be right; <code>plain</code> is M\u00F6ller and Trumbore\u2019s test "
            "in float. With no wrong answer among n, the true share is below 3/n at a confidence of 95 %. The largest "
            "error in t is relative, of the hits that are right.") +
        hitPlot(scene);
    std::vector<HtmlRow> rows{{"traversal, triangle test", "wrong / million", "wrong (missed, false)", "judged",
                               "undecided", "error in t", "ms", "low\u2013high", "Mrays/s", "front"}};
    const std::vector<ErrorRow> errors = hitRows(scene);
    for (size_t i = 0; i < errors.size(); ++i) {
        const ErrorRow& row = errors[i];
        const SetErrors all = sumOf(scene.ways[i].sets);
        std::array<char, 32> largest{};
        std::snprintf(largest.data(), largest.size(), "%.1e", all.largestTError);
        rows.push_back({row.settings, errorText(row.error),
                        grouped(all.wrong) + " (" + grouped(all.missed) + ", " + grouped(all.falseHits) + ")",
                        grouped(all.judged), grouped(all.undecided), largest.data(), medianText(row.time),
                        rangeOf(row.time), fixed(mraysPerSecond(all.rays, row.time.median), 2), frontMark(row)});
    }
    return html + htmlTable("Ways to answer rays in " + scene.name, rows, "lrrrrrrrrl");
}

std::string countsText(const RayCounts& c) {
    return fixed(c.inner, 2) + " / " + fixed(c.leaves, 2) + " / " + fixed(c.triangles, 2);
}

double costOf(const RayCounts& c, SahCosts costs) {
    return double{costs.traverse} * c.inner + double{costs.leaf} * c.leaves + double{costs.intersect} * c.triangles;
}

// Per cent above the first row, of the cost of some counts.
template <class CountsOf>
std::string aboveFirst(const SceneErrors& scene, const TracedErrors& traced, SahCosts costs, CountsOf countsOf) {
    const double base = costOf(countsOf(scene.traced.front()), costs);
    return base > 0.0 ? errorText(percentAbove(costOf(countsOf(traced), costs), base)) : "-";
}

std::string lineCostTable(const SceneErrors& scene, SahCosts costs) {
    std::vector<HtmlRow> rows{{"builder", "expected", "whole lines", "until the first hit", "without a hit",
                               "from the hit on", "descent to the hit"}};
    for (const TracedErrors& traced : scene.traced) {
        const auto add = [&](auto countsOf) { rows.back().push_back(aboveFirst(scene, traced, costs, countsOf)); };
        rows.push_back({nameOf(scene.trees[traced.tree])});
        add([&](const TracedErrors& t) { return scene.trees[t.tree].expected; });
        add([](const TracedErrors& t) { return t.lines.unstopped; });
        add([](const TracedErrors& t) { return t.lines.hitting; });
        add([](const TracedErrors& t) { return t.lines.missing; });
        add([](const TracedErrors& t) { return t.lines.beyond; });
        add([](const TracedErrors& t) { return t.lines.descent; });
    }
    return htmlTable("Cost of lines above that through exact\u2019s tree, %", rows, "lrrrrrr");
}

std::string rayCostTable(const SceneErrors& scene, const ReportSettings& settings) {
    std::vector<HtmlRow> rows{{"builder"}};
    for (const char* name : kRaySets) rows[0].push_back(std::string(name) + ", " + settings.traversal);
    for (const char* name : kRaySets) rows[0].push_back(std::string(name) + ", restart");
    rows[0].push_back("time, " + settings.traversal);
    const std::vector<ErrorRow> times = rayRows(scene);
    for (size_t i = 0; i < scene.traced.size(); ++i) {
        const TracedErrors& traced = scene.traced[i];
        const auto add = [&](auto countsOf) {
            rows.back().push_back(aboveFirst(scene, traced, settings.costs, countsOf));
        };
        rows.push_back({nameOf(scene.trees[traced.tree])});
        for (size_t k = 0; k < kRaySets.size(); ++k) add([k](const TracedErrors& t) { return t.counts[k]; });
        for (size_t k = 0; k < kRaySets.size(); ++k) add([k](const TracedErrors& t) { return t.restartCounts[k]; });
        rows.back().push_back(errorText(times[i].error));
    }
    return htmlTable("Cost of rays above that through exact\u2019s tree, %", rows, "lrrrrrrr");
}

std::string fitSection(const SceneErrors& scene) {
    std::string html =
        headline("Fitted costs") +
        paragraph(
            "What a ray, an inner node visited and a triangle tested add to the time on this device: least squared "
            "relative error over the trees of the builders by surface area, none below 0. The heuristic\u2019s "
            "constants that follow, with an inner node at 15, are what the trees with fitted costs are built with "
            "(those of all rays); whether they pay is in the tables above.");
    std::vector<HtmlRow> rows{{"rays", "a ray, ns", "an inner node, ns", "a triangle, ns", "constants", "trees",
                               "off on average", "at most"}};
    for (const NamedFit& fit : scene.fits) {
        const FittedCosts& c = fit.costs;
        const std::optional<SahCosts> costs = sahCostsOf(c);
        rows.push_back({fit.rays, fixed(c.ray, 1), fixed(c.inner, 2), fixed(c.triangle, 2),
                        costs ? fixed(costs->traverse, 0) + " : " + fixed(costs->intersect, 2) : "-",
                        std::to_string(c.samples), fixed(100.0 * c.meanError, 1) + " %",
                        fixed(100.0 * c.largestError, 1) + " %"});
    }
    return html + htmlTable("Costs fitted to times in " + scene.name, rows, "lrrrrrrr");
}

std::string predictionSection(const SceneErrors& scene, const ReportSettings& settings) {
    std::string html =
        headline("Predicted against counted") +
        paragraph("The heuristic expects lines that come from outside, are distributed uniformly and never stop. Of " +
                  grouped(scene.traced.front().lines.lines) + " such lines, " +
                  grouped(scene.traced.front().lines.hits) +
                  " hit something. What it expects of them, what they meet, and what rays meet that do stop, start at "
                  "surfaces, and are not uniform: inner nodes / leaves / triangle tests per ray.");
    std::vector<HtmlRow> rows{{"builder", "expected", "uniform lines"}};
    for (const char* name : kRaySets) rows[0].push_back(std::string(name) + " rays");
    for (const TracedErrors& traced : scene.traced) {
        const TreeErrors& tree = scene.trees[traced.tree];
        rows.push_back(
            {nameOf(tree), tree.hasCost ? countsText(tree.expected) : "-", countsText(traced.lines.unstopped)});
        for (const RayCounts& counts : traced.counts) rows.back().push_back(countsText(counts));
    }
    html += htmlTable("Inner nodes / leaves / triangle tests", rows, "lrrrrr");
    html += paragraph(
        "The same as costs, " + fixed(settings.costs.traverse, 0) + " for an inner node and " +
        fixed(settings.costs.intersect, 0) +
        " for a test, in per cent above those through exact\u2019s tree. Lines are cut at their first hit: until "
        "there, "
        "and from there on; \u201Cdescent\u201D is the way from the root to the leaf of the hit alone, which every ray "
        "that starts at a surface pays first and restart pays again and again: the heuristic does not know it.");
    return html + lineCostTable(scene, settings.costs) + rayCostTable(scene, settings) + fitSection(scene);
}

std::string shapeSection(const SceneErrors& scene) {
    return headline("Shape: sizes and depths of leaves") +
           paragraph("Shares of all leaves, of each builder at its defaults; the scale is logarithmic.") +
           leafPlot(scene) + depthPlot(scene);
}

std::string pictureSection(const SceneErrors& scene) {
    if (scene.pictures.empty()) return "";
    return headline("Pictures of trees") +
           picturesOf(scene, "steps",
                      "Nodes and leaves that the ray of each pixel visits. One scale for all builders, up "
                      "to what all but one in 200 stay below in the tree of <code>exact</code>.") +
           picturesOf(scene, "leaves", "Triangles in the leaf where the ray of each pixel hits.") +
           picturesOf(scene, "cut",
                      "The cells that a plane through the middle of the scene cuts, across its shortest "
                      "side; coloured by the triangles in their leaf, white without any.");
}

std::string rateText(const PeerSetFigures& set) {
    if (set.runs.empty()) return "-";
    const Spread s = spreadOf(set.runs);
    return fixed(mraysPerSecond(set.rays, s.median), 2) + " (" + fixed(mraysPerSecond(set.rays, s.high), 2) + "\u2013" +
           fixed(mraysPerSecond(set.rays, s.low), 2) + ")";
}

std::string peerSection(const SceneErrors& scene) {
    std::vector<HtmlRow> rows{{"ray tracer", "triangle order", "build ms", "low\u2013high", "primary Mrays/s",
                               "diffuse Mrays/s", "shadow Mrays/s", "rays", "differing"}};
    for (const PeerFigures& peer : scene.peers) {
        if (!peer.missing.empty()) {
            rows.push_back({peer.name, peer.order, "missing: " + peer.missing, "", "", "", "", "", ""});
            continue;
        }
        const Spread build = spreadOf(peer.buildRuns);
        rows.push_back({peer.name, peer.order, medianText(build), rangeOf(build)});
        uint64_t rays = 0, differing = 0;
        for (const PeerSetFigures& set : peer.sets) {
            rows.back().push_back(set.isWrong() ? "wrong" : rateText(set));
            rays += set.rays;
            differing += set.disagreements;
        }
        rows.back().insert(rows.back().end(), {grouped(rays), grouped(differing)});
    }
    return headline("Other ray tracers on the same rays") +
           paragraph(
               "Each computes in float, so a few answers about rays that graze an edge differ from ours. Slow ones "
               "are given a sample of the rays.") +
           htmlTable("Peers in " + scene.name, rows, "llrrrrrrr");
}

}  // namespace

std::string sceneHtml(const SceneErrors& scene, const ReportSettings& settings) {
    std::string html = "<h2>" + escaped(scene.name) + "</h2>\n";
    if (!scene.failure.empty()) return html + "<p class=\"failure\">No figures: " + escaped(scene.failure) + "</p>\n";
    html += paragraph(grouped(scene.triangles) + " triangles.") + treeSection(scene) + raySection(scene, settings) +
            hitSection(scene) + pathSection(scene) + predictionSection(scene, settings) + shapeSection(scene) +
            pictureSection(scene);
    if (settings.withPeers) html += peerSection(scene);
    return html;
}

}  // namespace cleave
