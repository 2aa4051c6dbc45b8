// Where the time of a device's build goes: by pass and by level.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/build_passes.h"

namespace cleave {

// All runs of a pass, over the levels of one build.
struct PassWork {
    std::string name;
    double ms = 0.0;
    uint64_t runs = 0;        // those with something to do
    uint64_t workgroups = 0;  // of these
    // What the pass treats one by one, summed over its runs: references, chunks or nodes; `what` says which. Passes
    // that treat a level as a whole have no elements.
    const char* what = "";
    uint64_t elements = 0;
};

// Nodes and references within subtrees are on no level.
struct LevelWork {
    uint64_t references = 0;
    uint64_t nodes = 0;
    double ms = 0.0;
};

struct BuildProfile {
    std::vector<PassWork> passes;  // in the order in which they run first
    std::vector<LevelWork> levels;
    uint64_t nodes = 0;  // of the tree
};

// `ms`: what the arguments took, then every pass that cmdBuild() recorded (BuildInfo::onPass), in that order. `state`:
// as the build left it; `choice`: of its passes.
BuildProfile profileOf(std::span<const double> ms, const BuildState& state, uint32_t triangles, PassChoice choice);

}  // namespace cleave
