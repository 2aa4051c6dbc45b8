// What the trace kernels are given for a TraceInfo.
#pragma once

#include "cleave/cleave.hpp"
#include "shared/trace.h"

namespace cleave {

inline TracePush tracePush(const TraceInfo& info) noexcept {
    constexpr uint32_t kDefaultStepLimit = 1u << 20;
    TracePush push{};
    push.tree = info.tree;
    push.rays = info.rays;
    push.hits = info.hits;
    push.steps = info.steps;
    push.counters = info.counters;
    push.trails = info.trails;
    push.rayCount = info.count;
    push.stepLimit = info.stepLimit != 0 ? info.stepLimit : kDefaultStepLimit;
    push.hitsPerRay = info.hitsPerRay;
    push.flags = (info.fromHits ? kTraceFromHits : 0u) | (info.resumes ? kTraceResumes : 0u) |
                 (info.trails ? kTraceTrails : 0u) | (info.counters ? kTraceCounters : 0u);
    return push;
}

}  // namespace cleave
