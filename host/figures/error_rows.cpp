#include "figures/error_rows.h"

#include <algorithm>

namespace cleave {
namespace {

bool beats(const ErrorRow& one, const ErrorRow& other) {
    const bool atMost = one.error <= other.error && one.time.median <= other.time.median;
    return atMost && (one.error < other.error || one.time.median < other.time.median);
}

ErrorRow rowOf(const SceneErrors& scene, const std::string& builder, const std::string& settings) {
    ErrorRow row;
    row.scene = scene.name;
    row.builder = builder;
    row.settings = settings;
    return row;
}

}  // namespace

void markPareto(std::vector<ErrorRow>& rows) {
    for (ErrorRow& row : rows) {
        row.pareto = true;
        for (const ErrorRow& other : rows)
            if (other.scene == row.scene && beats(other, row)) row.pareto = false;
    }
}

double percentAbove(double value, double base) { return 100.0 * (value / base - 1.0); }

Spread timeOfAll(const AllSetErrors& sets) {
    std::vector<double> sums;
    for (const SetErrors& set : sets) {
        sums.resize(std::max(sums.size(), set.runs.size()));
        for (size_t i = 0; i < set.runs.size(); ++i) sums[i] += set.runs[i];
    }
    return sums.empty() ? Spread{} : spreadOf(sums);
}

SetErrors sumOf(const AllSetErrors& sets) {
    SetErrors sum;
    for (const SetErrors& set : sets) {
        sum.rays += set.rays;
        sum.judged += set.judged;
        sum.wrong += set.wrong;
        sum.missed += set.missed;
        sum.falseHits += set.falseHits;
        sum.undecided += set.undecided;
        sum.largestTError = std::max(sum.largestTError, set.largestTError);
    }
    return sum;
}

RayCounts meanCounts(const TracedErrors& traced) {
    RayCounts mean;
    const double rays = std::max(static_cast<double>(sumOf(traced.sets).rays), 1.0);
    for (size_t k = 0; k < kRaySets.size(); ++k) {
        const double share = static_cast<double>(traced.sets[k].rays) / rays;
        mean.inner += share * traced.counts[k].inner;
        mean.leaves += share * traced.counts[k].leaves;
        mean.triangles += share * traced.counts[k].triangles;
    }
    return mean;
}

std::vector<ErrorRow> treeRows(const SceneErrors& scene) {
    std::vector<ErrorRow> rows;
    for (const TreeErrors& tree : scene.trees) {
        if (!tree.hasCost || !(scene.trees.front().sahCost > 0.0)) continue;
        ErrorRow row = rowOf(scene, tree.builder, tree.settings);
        row.error = row.errorLow = row.errorHigh = percentAbove(tree.sahCost, scene.trees.front().sahCost);
        row.time = spreadOf(tree.runs);
        rows.push_back(row);
    }
    markPareto(rows);
    return rows;
}

std::vector<ErrorRow> rayRows(const SceneErrors& scene) {
    std::vector<ErrorRow> rows;
    for (const TracedErrors& traced : scene.traced) {
        const TreeErrors& tree = scene.trees[traced.tree];
        const Spread time = timeOfAll(traced.sets);
        const double base = timeOfAll(scene.traced.front().sets).median;
        ErrorRow row = rowOf(scene, tree.builder, tree.settings);
        row.error = percentAbove(time.median, base);
        row.errorLow = percentAbove(time.low, base);
        row.errorHigh = percentAbove(time.high, base);
        row.time = spreadOf(tree.runs);
        rows.push_back(row);
    }
    markPareto(rows);
    return rows;
}

std::vector<ErrorRow> hitRows(const SceneErrors& scene) {
    std::vector<ErrorRow> rows;
    for (const WayErrors& way : scene.ways) {
        const SetErrors all = sumOf(way.sets);
        ErrorRow row = rowOf(scene, "gpu", way.traversal + ", " + way.test);
        row.error = all.judged > 0 ? 1e6 * static_cast<double>(all.wrong) / static_cast<double>(all.judged) : 0.0;
        row.errorLow = row.errorHigh = row.error;
        row.time = timeOfAll(way.sets);
        rows.push_back(row);
    }
    markPareto(rows);
    return rows;
}

Json errorRowsJson(const std::vector<ErrorRow>& rows) {
    Json json = Json::array();
    for (const ErrorRow& row : rows)
        json.push_back({{"scene", row.scene},
                        {"builder", row.builder},
                        {"settings", row.settings},
                        {"error", numberJson(row.error)},
                        {"errorLow", numberJson(row.errorLow)},
                        {"errorHigh", numberJson(row.errorHigh)},
                        {"ms", numberJson(row.time.median)},
                        {"msLow", numberJson(row.time.low)},
                        {"msHigh", numberJson(row.time.high)},
                        {"runs", row.time.runs},
                        {"pareto", row.pareto}});
    return json;
}

}  // namespace cleave
