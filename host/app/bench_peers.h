// Other ray tracers on the rays of a benchmark.
#pragma once

#include "app/bench_rays.h"
#include "figures/peer_figures.h"

namespace cleave {

// Measures every peer that is here, after comparing its answers with ours; what is not here is said. `built` has the
// tree that the stack walk goes through.
std::vector<PeerFigures> benchPeers(Run& run, const Session& session, const BuiltTree& built, const RaySets& sets);

}  // namespace cleave
