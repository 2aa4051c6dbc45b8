#include "core/context.h"
#include "core/trace_push.h"

namespace cleave {

void cmdTrace(VkCommandBuffer commands, const Context& context, const TraceInfo& info) noexcept {
    const Context::State& state = context.state();
    state.recorder(commands).dispatch(state.kernelOf(info.mode), tracePush(info), ceilDiv(info.count, kGroup));
}

}  // namespace cleave
