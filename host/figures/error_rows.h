// Error against run time: one row per way to compute something, and which of them no other beats.
#pragma once

#include <string>
#include <vector>

#include "figures/json.h"
#include "figures/scene_errors.h"
#include "figures/timing.h"

namespace cleave {

struct ErrorRow {
    std::string scene, builder, settings;
    double error = 0.0;
    double errorLow = 0.0, errorHigh = 0.0;  // apart where the error is itself made of times
    Spread time;
    bool pareto = false;
};

// Puts a row on the front if no other row of its scene is at most as large in both error and median time, and smaller
// in one. Equal rows are on it together.
void markPareto(std::vector<ErrorRow>& rows);

// Per cent of SAH cost above that of the first tree, and the build's time; one per tree whose cost is defined.
std::vector<ErrorRow> treeRows(const SceneErrors& scene);
// Per cent of tracing time above that through the first tree, and the build's time; one per traced tree.
std::vector<ErrorRow> rayRows(const SceneErrors& scene);
// Wrong answers per million, and the time of the rays; one per way.
std::vector<ErrorRow> hitRows(const SceneErrors& scene);

// The sets one after the other: run i is the sum of their runs i.
Spread timeOfAll(const AllSetErrors& sets);
// Their rays, added up; no runs.
SetErrors sumOf(const AllSetErrors& sets);

// What a ray of all sets meets on the average.
RayCounts meanCounts(const TracedErrors& traced);

double percentAbove(double value, double base);

Json errorRowsJson(const std::vector<ErrorRow>& rows);

}  // namespace cleave
