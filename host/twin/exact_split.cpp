#include "twin/passes.h"

namespace cleave::twin {

namespace {

Split bestFace(SahCosts costs, const PrimRef* refs, const BuildNode& node) {
    Split best = noSplit();
    for (uint32_t axis = 0; axis < 3; axis++) {
        const int k = static_cast<int>(axis);
        for (uint32_t i = 0; i < 2 * node.count; i++) {
            const float plane = i % 2 == 0 ? refs[i / 2].lo[k] : refs[i / 2].hi[k];
            uint32_t left = 0;
            uint32_t right = 0;
            uint32_t planar = 0;
            for (uint32_t j = 0; j < node.count; j++) {
                left += refs[j].lo[k] < plane;
                right += refs[j].hi[k] > plane;
                planar += refs[j].lo[k] == plane && refs[j].hi[k] == plane;
            }
            best = betterOfBothSides(best, costs, node.cell, axis, plane, left, right, planar);
        }
    }
    return best;
}

}  // namespace

void exactSplit(BuildArrays& a, uint32_t depth) {
    for (uint32_t n = 0; n < a.state.level[depth].nodeCount; n++) {
        BuildNode& node = a.nodesIn(depth)[n];
        if (isLarge(node.count, a.args.exactUpTo)) continue;
        const Split best = bestFace(a.args.costs, &a.refsIn(depth)[node.first], node);
        if (isWorthwhile(a.args.costs, best, node.cell, node.count, depth, a.state.maxDepth)) node.split = best;
    }
}

}  // namespace cleave::twin
