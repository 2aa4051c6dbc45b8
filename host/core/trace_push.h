// What the trace kernels are given for a TraceInfo.
#pragma once

#include "cleave/cleave.hpp"
#include "shared/trace.h"

namespace cleave {

// Whether a dispatch may give up on a ray, for which a next one goes on. With a stack no node is visited twice; of a
// ray through many trees a trail says too little. A ray that waits goes on in any case.
inline bool mayGoOn(const TraceMode& mode) noexcept {
    return (mode.query == Query::closest || mode.query == Query::any) &&
           (mode.traversal != Traversal::stack || mode.lazy) && !mode.instances && !mode.single;
}

// Whether there is a kernel for a single leaf (TraceMode::single) that answers as the mode wants it.
inline bool mayBeSingle(const TraceMode& mode) noexcept {
    return !mode.countSteps && mode.test == TriangleTest::watertight;
}

inline TracePush tracePush(const TraceInfo& info) noexcept {
    constexpr uint32_t kDefaultStepLimit = 1u << 20;
    TracePush push{};
    push.tree = info.tree;
    push.rays = info.rays;
    push.hits = info.hits;
    push.steps = info.steps;
    push.counters = info.counters;
    push.trails = info.trails;
    push.open = info.open;
    push.rayCount = info.count;
    push.stepLimit = info.stepLimit != 0 ? info.stepLimit : kDefaultStepLimit;
    push.hitsPerRay = info.hitsPerRay;
    push.flags = (info.fromHits ? kTraceFromHits : 0u) | (info.resumes ? kTraceResumes : 0u) |
                 (info.trails ? kTraceTrails : 0u) | (info.counters ? kTraceCounters : 0u) |
                 (info.hitScale != HitScale::world ? kTraceBetween : 0u) |
                 (info.hitScale == HitScale::last ? kTraceLast : 0u);
    push.hitExponent = info.hitExponent;
    return push;
}

}  // namespace cleave
