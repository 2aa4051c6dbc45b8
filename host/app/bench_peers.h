// The rays of a benchmark, and other ray tracers on the same.
#pragma once

#include <array>

#include "app/session.h"
#include "figures/peer_figures.h"

namespace cleave {

struct RaySet {
    std::vector<Ray> rays;
    Query query = Query::closest;
    std::vector<Hit> hits;  // our answers, by the first builder in the first mode
};
using RaySets = std::array<RaySet, kRaySets.size()>;

// Measures every peer that is here, after comparing its answers with ours; what is not here is said. `built` has the
// tree that the stack walk goes through.
std::vector<PeerFigures> benchPeers(Run& run, const Session& session, const BuiltTree& built, const RaySets& sets);

}  // namespace cleave
