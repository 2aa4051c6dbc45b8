// What a benchmark measured, and how it is shown.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/session.h"

namespace cleave {

constexpr std::array<const char*, 3> kRaySets = {"primary", "diffuse", "shadow"};

struct SetFigures {
    uint64_t rays = 0;
    double ms = 0.0;  // median of the runs
    uint64_t invalidRays = 0;
    uint64_t cappedRays = 0;
    CheckResult check;
};

// One builder on one scene. The tree itself is gone by then.
struct BuilderFigures {
    BuiltTree built;
    std::array<SetFigures, kRaySets.size()> sets;
};

// A row per builder; SAH cost and references also as ratios to the builder `exact` where that is among them.
// `included` triangles are in the tree.
std::string treeTable(const std::vector<BuilderFigures>& figures, uint64_t included);
std::string rayTable(const std::vector<BuilderFigures>& figures);

}  // namespace cleave
