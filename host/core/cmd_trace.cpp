#include "core/context.h"
#include "shared/trace.h"

namespace cleave {

void cmdTrace(VkCommandBuffer commands, const Context& context, const TraceInfo& info) noexcept {
    constexpr uint32_t kDefaultStepLimit = 1u << 20;
    const Context::State& state = context.state();
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
    state.recorder(commands).dispatch(state.kernelOf(info.mode), push, ceilDiv(info.count, kGroup));
}

}  // namespace cleave
