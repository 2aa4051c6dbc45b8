// Error against run time: one row per way to compute something, and which of them no other beats.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "figures/json.h"
#include "figures/peer_figures.h"
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

Json errorRowsJson(const std::vector<ErrorRow>& rows);

// What a row about rays is made of: the build, and each of the sets.
struct RayTimes {
    std::string builder;
    Spread build;
    std::array<Spread, kRaySets.size()> sets;  // no runs: no rays
    Spread all;                                // the sets one after the other
};

// Of a row about hits.
struct JudgedRays {
    uint64_t judged = 0, wrong = 0, undecided = 0;
    uint64_t traced = 0;  // rays that the time is of
};

// All figures of a scene.
struct SceneErrors {
    std::string name;
    uint64_t triangles = 0;
    std::string failure;             // why there are no figures; empty: there are
    std::vector<ErrorRow> tree;      // per cent of SAH cost above that of `exact`, and the build's time
    std::vector<ErrorRow> rays;      // per cent of tracing time above that through the tree of `exact`, the same
    std::vector<RayTimes> rayTimes;  // one per row of `rays`
    std::vector<ErrorRow> hits;      // wrong answers per million, and the time of the rays
    std::vector<JudgedRays> judged;  // one per row of `hits`
    std::vector<PeerFigures> peers;
    std::vector<std::string> withoutCost;  // builders whose tree has no SAH cost
};

// {"tree": rows, "rays": rows, "hits": rows} of all scenes.
Json errorsJson(const std::vector<SceneErrors>& scenes);

}  // namespace cleave
