// Measurements of peers beside ours: the table and the JSON.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "figures/bench_figures.h"
#include "figures/json.h"

namespace cleave {

struct PeerSetFigures {
    uint64_t rays = 0;           // all of the set, or a sample where the peer is slow
    uint64_t disagreements = 0;  // of them, with our answers
    std::vector<double> runs;    // ms of each; none where too many disagree

    // Beyond one per cent the peer answers another question, and its time means nothing.
    bool isWrong() const { return disagreements * 100 > rays; }
};

struct PeerFigures {
    std::string name;
    std::string order;              // of the triangles: file, morton
    std::string missing;            // why there are no figures; empty: there are
    std::vector<double> buildRuns;  // ms of each
    std::array<PeerSetFigures, kRaySets.size()> sets;
};

// A row for each of our builders and modes, then one per peer: medians and ranges. `ours/` is our best rate over the
// peer's, on the same set.
std::string peerTable(const std::vector<BuilderFigures>& ours, const std::vector<PeerFigures>& peers);

Json peerJson(const PeerFigures& peer);

}  // namespace cleave
