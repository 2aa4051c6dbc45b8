#include "figures/stability_figures.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "base/text.h"

namespace cleave {
namespace {

using Row = std::vector<std::string>;

// Sums and worst figures of some cells.
struct Sum {
    uint64_t cells = 0, rays = 0, wrong = 0, missed = 0, falseHits = 0, undecided = 0, differing = 0, capped = 0;
    double maxUlpError = 0.0, maxRelativeError = 0.0, ms = 0.0;
    uint32_t mostSteps = 0;

    void add(const Cell& cell) {
        ++cells;
        rays += cell.rays;
        wrong += cell.wrong;
        missed += cell.missed;
        falseHits += cell.falseHits;
        undecided += cell.undecided;
        differing += cell.differing;
        capped += cell.capped;
        maxUlpError = std::max(maxUlpError, cell.maxUlpError);
        maxRelativeError = std::max(maxRelativeError, cell.maxRelativeError);
        mostSteps = std::max(mostSteps, cell.mostSteps);
        ms += cell.ms;
    }
};

std::string shortly(double value) {
    if (value == 0.0) return "0";
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", value);
    return text;
}

const Row kSumHeader{"cells",  "rays",   "wrong", "missed", "false", "undec.",
                     "differ", "capped", "t ulp", "t rel.", "steps", "ms"};

Row sumRow(const Sum& s) {
    return {grouped(s.cells),        grouped(s.rays),
            grouped(s.wrong),        grouped(s.missed),
            grouped(s.falseHits),    grouped(s.undecided),
            grouped(s.differing),    grouped(s.capped),
            fixed(s.maxUlpError, 2), shortly(s.maxRelativeError),
            grouped(s.mostSteps),    fixed(s.ms, 0)};
}

Row joined(Row row, const Row& more) {
    row.insert(row.end(), more.begin(), more.end());
    return row;
}

std::string sceneTable(const std::vector<SceneFigures>& scenes) {
    std::vector<Row> rows{joined({"case", "triangles", "depth", "refs/tri"}, kSumHeader)};
    for (const SceneFigures& scene : scenes) {
        Sum sum;
        for (const Cell& cell : scene.cells) sum.add(cell);
        uint32_t depth = 0;
        double references = 0.0;
        for (const TreeFigures& tree : scene.trees) {
            depth = std::max(depth, tree.maxDepth);
            references = std::max(references, tree.referencesPerTriangle);
        }
        rows.push_back(joined(
            {oneLine(scene.name), grouped(scene.triangles), std::to_string(depth), fixed(references, 1)}, sumRow(sum)));
    }
    return alignedTable(rows, "lrrr" + std::string(kSumHeader.size(), 'r'));
}

// A row per value of key(cell), in the order in which the values first come.
template <class Key>
std::string tableBy(const std::vector<SceneFigures>& scenes, const Row& header, Key key) {
    std::vector<Row> keys;
    std::map<Row, Sum> sums;
    for (const SceneFigures& scene : scenes)
        for (const Cell& cell : scene.cells) {
            const auto [at, isNew] = sums.try_emplace(key(cell));
            if (isNew) keys.push_back(at->first);
            at->second.add(cell);
        }
    std::vector<Row> rows{joined(header, kSumHeader)};
    for (const Row& k : keys) rows.push_back(joined(k, sumRow(sums[k])));
    return alignedTable(rows, std::string(header.size(), 'l') + std::string(kSumHeader.size(), 'r'));
}

std::string brokenCells(const std::vector<SceneFigures>& scenes) {
    std::string text;
    for (const SceneFigures& scene : scenes)
        for (const Cell& cell : scene.cells) {
            const std::string why = whyBroken(cell);
            if (why.empty()) continue;
            text += oneLine(cell.scene) + ", " + cell.builder + ", " + cell.traversal + ", " + cell.family + ": " +
                    why + " of " + grouped(cell.rays) + " rays\n  " + cell.first + "\n";
        }
    return text.empty() ? "all cells are within their bounds\n" : "cells out of bounds:\n" + text;
}

// A row per scene, a column per query, each with what differs under any builder, of what was asked.
std::string queryTable(const std::vector<SceneFigures>& scenes) {
    std::vector<Row> rows;
    for (const SceneFigures& scene : scenes) {
        std::vector<std::pair<std::string, QueryCell>> sums;
        for (const QueryCell& cell : scene.queries) {
            auto sum = std::find_if(sums.begin(), sums.end(), [&](const auto& s) { return s.first == cell.query; });
            if (sum == sums.end()) sum = sums.insert(sum, {cell.query, {}});
            sum->second.asked += cell.asked;
            sum->second.differing += cell.differing;
        }
        if (sums.empty()) continue;
        Row header{"queries that differ"}, row{oneLine(scene.name)};
        for (const auto& [query, sum] : sums) {
            header.push_back(query);
            row.push_back(grouped(sum.differing) + " of " + grouped(sum.asked));
        }
        if (rows.empty()) rows.push_back(header);
        rows.push_back(row);
    }
    return rows.empty() ? "" : "\n" + alignedTable(rows, "l" + std::string(rows.front().size() - 1, 'r'));
}

Json cellJson(const Cell& cell) {
    return {{"case", cell.scene},
            {"builder", cell.builder},
            {"traversal", cell.traversal},
            {"family", cell.family},
            {"edgeFamily", cell.isEdgeFamily},
            {"rays", cell.rays},
            {"hits", cell.hits},
            {"wrong", cell.wrong},
            {"missed", cell.missed},
            {"false", cell.falseHits},
            {"undecided", cell.undecided},
            {"differing", cell.differing},
            {"expectedBy", cell.byBruteForce ? "brute force" : "first builder"},
            {"cappedRays", cell.capped},
            {"maxUlpTError", cell.maxUlpError},
            {"maxRelativeTError", cell.maxRelativeError},
            {"mostSteps", cell.mostSteps},
            {"ms", numberJson(cell.ms)},
            {"broken", whyBroken(cell)}};
}

}  // namespace

std::string stabilityText(const std::vector<SceneFigures>& scenes) {
    const std::string families =
        tableBy(scenes, {"rays"}, [](const Cell& c) { return Row{c.family + (c.isEdgeFamily ? " *" : "")}; });
    return sceneTable(scenes) + "\n" +
           tableBy(scenes, {"builder", "traversal"},
                   [](const Cell& c) {
                       return Row{c.builder, c.traversal};
                   }) +
           "\n" + families + "* at edges, vertices or ends on purpose: what is undecided is not bounded\n\n" +
           brokenCells(scenes) + queryTable(scenes);
}

Json stabilityJson(const std::vector<SceneFigures>& scenes) {
    Json cases = Json::array(), cells = Json::array(), queries = Json::array();
    uint64_t broken = 0, differing = 0;
    for (const SceneFigures& scene : scenes) {
        Json trees = Json::array();
        for (const TreeFigures& tree : scene.trees)
            trees.push_back({{"builder", tree.builder},
                             {"nodes", tree.nodes},
                             {"maxDepth", tree.maxDepth},
                             {"referencesPerTriangle", tree.referencesPerTriangle},
                             {"ms", numberJson(tree.buildMs)}});
        cases.push_back({{"name", scene.name},
                         {"about", scene.about},
                         {"triangles", scene.triangles},
                         {"included", scene.included},
                         {"builds", trees}});
        for (const Cell& cell : scene.cells) {
            cells.push_back(cellJson(cell));
            broken += whyBroken(cell).empty() ? 0 : 1;
        }
    }
    for (const SceneFigures& scene : scenes)
        for (const QueryCell& cell : scene.queries) {
            queries.push_back({{"case", cell.scene},
                               {"builder", cell.builder},
                               {"query", cell.query},
                               {"asked", cell.asked},
                               {"differing", cell.differing}});
            differing += cell.differing;
        }
    return {{"cases", cases},
            {"cells", cells},
            {"brokenCells", broken},
            {"queries", queries},
            {"differingQueries", differing}};
}

}  // namespace cleave
