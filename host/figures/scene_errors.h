// What `cleave report` measures in a scene, as it was measured. Rows and pages are made from it.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "figures/bench_figures.h"
#include "figures/fitted_costs.h"
#include "figures/peer_figures.h"

namespace cleave {

inline constexpr const char* kDefaultSettings = "defaults";

// Nodes visited and triangles tested, per ray.
struct RayCounts {
    double inner = 0.0, leaves = 0.0, triangles = 0.0;
};

// A tree by a builder with some settings.
struct TreeErrors {
    std::string builder, settings;
    std::vector<double> runs;  // ms of each build
    bool hasCost = false;      // the root box has an area, and so what follows is defined
    double sahCost = 0.0;      // by the report's costs, whatever the tree was built with
    RayCounts expected;        // of a uniformly distributed line
    uint64_t nodes = 0, references = 0;
    std::vector<uint64_t> leafHistogram, depthHistogram;  // as in TreeStatistics
};

// A set of rays that a way of answering them was given.
struct SetErrors {
    uint64_t rays = 0;
    uint64_t judged = 0, wrong = 0, missed = 0, falseHits = 0, undecided = 0;
    double largestTError = 0.0;  // relative, of closest hits that are right
    std::vector<double> runs;    // ms of each; none without rays
};
using AllSetErrors = std::array<SetErrors, kRaySets.size()>;

// What uniformly distributed lines meet in a tree, and what parts of them do.
struct LineErrors {
    RayCounts unstopped;  // all of every line, as the heuristic has it
    RayCounts hitting;    // of lines that hit something: until there
    RayCounts missing;    // of lines that hit nothing
    RayCounts beyond;     // of lines that hit something: from there on, all the rest
    RayCounts descent;    // the nodes above the first hit alone, and its leaf
    uint64_t lines = 0, hits = 0;
};

// Rays through a tree.
struct TracedErrors {
    size_t tree = 0;  // which one of `trees`
    AllSetErrors sets;
    std::array<RayCounts, kRaySets.size()> counts;         // by the traversal that is timed
    std::array<RayCounts, kRaySets.size()> restartCounts;  // by restart, with what it visits again
    LineErrors lines;
};

// A traversal with a triangle test.
struct WayErrors {
    std::string traversal, test;
    AllSetErrors sets;
};

// What nodes and tests take in a set of rays, or in all.
struct NamedFit {
    std::string rays;
    FittedCosts costs;
};

// A picture beside the page.
struct ReportPicture {
    std::string kind;     // what it shows: steps, leaves, cut, paths
    std::string caption;  // the builder; of paths, the samples
    std::string png;      // the file's bytes, in base64
};

// Pictures of paths with so many samples of a pixel, each with a seed of its own.
struct SampledPictures {
    uint32_t samples = 0;
    std::vector<double> errors;        // of each: relativeRmse() against the reference, per cent
    std::vector<double> similarities;  // of each: structuralSimilarity() with it
    std::vector<double> runs;          // ms of each, all passes on the device
};

// How pictures of paths come near a converged one.
struct PathErrors {
    std::string builder;  // of the tree
    uint32_t width = 0, height = 0;
    uint32_t referenceSamples = 0, referenceParts = 0;
    double referenceError = 0.0;            // MeanPicture::error, per cent
    std::vector<SampledPictures> pictures;  // ascending in samples; empty: none were made
};

struct SceneErrors {
    std::string name;
    uint64_t triangles = 0;
    std::string failure;            // why there are no figures; empty: there are
    std::vector<TreeErrors> trees;  // the first is that of `exact`, which the others are measured against
    std::vector<TracedErrors> traced;
    std::vector<WayErrors> ways;  // through the tree of `gpu`
    PathErrors paths;
    std::vector<PeerFigures> peers;
    std::vector<ReportPicture> pictures;
    std::vector<NamedFit> fits;                                // to the times of the first turn
    std::vector<std::pair<std::string, std::string>> leftOut;  // what, and why
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RayCounts, inner, leaves, triangles)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TreeErrors, builder, settings, runs, hasCost, sahCost, expected, nodes, references,
                                   leafHistogram, depthHistogram)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetErrors, rays, judged, wrong, missed, falseHits, undecided, largestTError, runs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LineErrors, unstopped, hitting, missing, beyond, descent, lines, hits)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ReportPicture, kind, caption, png)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PeerSetFigures, rays, disagreements, runs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PeerFigures, name, order, missing, buildRuns, sets)

}  // namespace cleave
