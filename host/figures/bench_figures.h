// Measurements of a benchmark and their tables.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "figures/built_tree.h"
#include "figures/ray_work.h"

namespace cleave {

constexpr std::array<const char*, 3> kRaySets = {"primary", "diffuse", "shadow"};

struct SetFigures {
    uint64_t rays = 0;
    double ms = 0.0;  // median of the runs
    uint64_t invalidRays = 0;
    uint64_t cappedRays = 0;
    CheckResult check;
    std::string hitsHash;
    std::optional<RayWork> work;  // where it is asked for, or triangle tests are compared
    std::vector<double> runs;     // ms of each
};

// Figures of one traversal with one triangle test.
struct ModeFigures {
    Traversal traversal = Traversal::restart;
    TriangleTest test = TriangleTest::watertight;
    std::array<SetFigures, kRaySets.size()> sets;
};

// One builder on one scene. The tree itself is gone by then.
struct BuilderFigures {
    BuiltTree built;
    std::vector<ModeFigures> modes;
};

// A row per builder; SAH cost and references also as ratios to the builder `exact` where that is among them.
// `included` triangles are in the tree.
std::string treeTable(const std::vector<BuilderFigures>& figures, uint64_t included);
// A row per builder and mode.
std::string rayTable(const std::vector<BuilderFigures>& figures);

// A row per builder, mode and set of rays: what a ray does on its way.
std::string workTable(const std::vector<BuilderFigures>& figures);

// A row per pass of each build on the device, and one per level: its time for each element, reference of a level and
// node of the tree. Empty without such a build.
std::string passTable(const std::vector<BuilderFigures>& figures);

// A hash of the answers, 16 hexadecimal digits: of every bit of closest hits, in the order of their rays. Of any hits
// only which rays hit counts, for the triangle that is found first depends on the tree.
std::string hitsHash(std::span<const Hit> hits, Query query);

// Where the time of GPU builds goes, in per cent by kernel, the dearest first; empty without one.
std::string kernelLines(const std::vector<BuilderFigures>& figures);

}  // namespace cleave
