// The rays of a benchmark, and how long they take.
#pragma once

#include <array>

#include "app/session.h"
#include "figures/bench_figures.h"
#include "scene/ray_sets.h"

namespace cleave {

struct RaySet {
    std::vector<Ray> rays;
    Query query = Query::closest;
    std::vector<Hit> hits;  // our answers, by the first builder in the first mode
};
using RaySets = std::array<RaySet, kRaySets.size()>;

// Secondary rays start from primary hits, so the first builder's answers are needed; all builders then get these rays.
void makeSecondaryRays(RaySets& sets, const Session& session, uint32_t size = kRaySetSize);

// Times `runs` runs, and proves `judged` of the rays right: throws Error if one is not. The plain triangle test is not
// right: how often it is wrong is a figure. The answers go to `hits` where that is given.
SetFigures measureSet(Run& run, Session& session, const DeviceTree& tree, const RaySet& set, TraceMode mode,
                      const std::string& name, uint32_t runs, uint64_t judged, std::vector<Hit>* hits);

}  // namespace cleave
