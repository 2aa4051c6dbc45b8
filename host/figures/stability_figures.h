// Results of a run of `cleave stability` as text and JSON.
#pragma once

#include <string>
#include <vector>

#include "figures/json.h"
#include "stability/cell.h"
#include "stability/query_sweep.h"

namespace cleave {

struct TreeFigures {
    std::string builder;
    uint64_t nodes = 0;
    uint32_t maxDepth = 0;
    double referencesPerTriangle = 0.0;
    double buildMs = 0.0;
};

// One scene under all its builders.
struct SceneFigures {
    std::string name, about;
    uint64_t triangles = 0;
    uint64_t included = 0;
    std::vector<TreeFigures> trees;
    std::vector<Cell> cells;
    std::vector<QueryCell> queries;
};

// Thousands of cells are no reading: a row per scene, one per builder and traversal, one per family of rays, each with
// the sums and the worst of its cells; then every broken cell in full; then a row per scene of the other queries, of
// which each must answer as brute force.
std::string stabilityText(const std::vector<SceneFigures>& scenes);
// Every cell.
Json stabilityJson(const std::vector<SceneFigures>& scenes);

}  // namespace cleave
