#include "core/context.h"
#include "shared/query.h"

namespace cleave {

void cmdSearch(VkCommandBuffer commands, const Context& context, const SearchInfo& info) noexcept {
    const Context::State& state = context.state();
    QueryPush push{};
    push.tree = info.tree;
    push.items = info.items;
    push.nearest = info.answers;
    push.answers = info.answers;
    push.first = info.first;
    push.triangles = info.numbers;
    push.count = info.count;
    push.within = info.within;
    state.recorder(commands).dispatch(state.kernelOf(info.search), push, ceilDiv(info.count, kGroup));
}

}  // namespace cleave
