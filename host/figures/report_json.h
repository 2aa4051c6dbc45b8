// The figures of a report for scripts.
#pragma once

#include "figures/json.h"
#include "figures/report_page.h"

namespace cleave {

// errors.tree, errors.rays, errors.hits, errors.picture: rows of scene, builder, settings, error, errorLow, errorHigh,
// ms, msLow, msHigh, runs, pareto. predictions: what the heuristic expects of a tree, and what lines and rays counted.
// fitted: the nanoseconds of nodes and tests, by scene. picture: how the error of pictures falls. leftOut: what, why.
Json reportJson(const ReportPage& page);

}  // namespace cleave
