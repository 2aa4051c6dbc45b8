#include "twin/passes.h"

namespace cleave::twin {

#define CLEAVE_ROW(kernel, twin, groups, lanes, scans, builds) \
    Pass{{#kernel, offsetof(Level, groups), Lanes::lanes, scans, Builds::builds}, twin},

std::span<const Pass> setupPasses() {
    static constexpr Pass kPasses[] = {CLEAVE_SETUP_PASSES(CLEAVE_ROW)};
    return kPasses;
}
std::span<const Pass> expandPasses() {
    static constexpr Pass kPasses[] = {CLEAVE_EXPAND_PASSES(CLEAVE_ROW)};
    return kPasses;
}
std::span<const Pass> levelPasses() {
    static constexpr Pass kPasses[] = {CLEAVE_LEVEL_PASSES(CLEAVE_ROW)};
    return kPasses;
}
std::span<const Pass> lastPasses() {
    static constexpr Pass kPasses[] = {CLEAVE_LAST_PASSES(CLEAVE_ROW)};
    return kPasses;
}
#undef CLEAVE_ROW

void runLevels(BuildArrays& a, PassChoice choice) {
    for (uint32_t depth = 0; depth <= a.state.maxDepth && a.state.level[depth].nodeCount > 0; depth++)
        for (const Pass& pass : levelPasses())
            if (pass.row.runs(choice)) pass.run(a, depth);
    for (const Pass& pass : lastPasses()) pass.run(a, 0);
}

}  // namespace cleave::twin
