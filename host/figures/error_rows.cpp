#include "figures/error_rows.h"

namespace cleave {
namespace {

bool beats(const ErrorRow& one, const ErrorRow& other) {
    const bool atMost = one.error <= other.error && one.time.median <= other.time.median;
    return atMost && (one.error < other.error || one.time.median < other.time.median);
}

}  // namespace

void markPareto(std::vector<ErrorRow>& rows) {
    for (ErrorRow& row : rows) {
        row.pareto = true;
        for (const ErrorRow& other : rows)
            if (other.scene == row.scene && beats(other, row)) row.pareto = false;
    }
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

Json errorsJson(const std::vector<SceneErrors>& scenes) {
    Json tree = Json::array(), rays = Json::array(), hits = Json::array();
    const auto add = [](Json& to, const std::vector<ErrorRow>& rows) {
        for (const Json& row : errorRowsJson(rows)) to.push_back(row);
    };
    for (const SceneErrors& scene : scenes) {
        add(tree, scene.tree);
        add(rays, scene.rays);
        add(hits, scene.hits);
    }
    return {{"tree", tree}, {"rays", rays}, {"hits", hits}};
}

}  // namespace cleave
