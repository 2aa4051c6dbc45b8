#include "twin/passes.h"

namespace cleave::twin {

Split bestFace(SahCosts costs, std::span<const PrimRef> refs, Box cell) {
    Split best = noSplit();
    for (uint32_t axis = 0; axis < 3; axis++) {
        const int k = static_cast<int>(axis);
        for (size_t i = 0; i < 2 * refs.size(); i++) {
            const float plane = i % 2 == 0 ? refs[i / 2].lo[k] : refs[i / 2].hi[k];
            uint32_t left = 0;
            uint32_t right = 0;
            uint32_t planar = 0;
            for (const PrimRef& r : refs) {
                left += r.lo[k] < plane;
                right += r.hi[k] > plane;
                planar += r.lo[k] == plane && r.hi[k] == plane;
            }
            best = betterOfBothSides(best, costs, cell, axis, plane, left, right, planar);
        }
    }
    return best;
}

void exactSplit(BuildArrays& a, uint32_t depth) {
    for (uint32_t n = 0; n < a.state.level[depth].nodeCount; n++) {
        BuildNode& node = a.nodesIn(depth)[n];
        if (isLarge(node.count, a.args.exactUpTo) || node.split.axis == kSubtreeAxis) continue;
        const Split best =
            bestFace(a.args.costs, std::span(a.refsIn(depth)).subspan(node.first, node.count), node.cell);
        if (isWorthwhile(a.args.costs, best, node.cell, node.count, depth, a.state.maxDepth)) node.split = best;
    }
}

}  // namespace cleave::twin
