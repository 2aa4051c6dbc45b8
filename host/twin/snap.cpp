#include "twin/passes.h"

namespace cleave::twin {

void snap(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        BuildNode& node = a.nodesIn(depth)[a.chunks[c].node];
        if (node.chunk != c || node.split.axis == kLeafAxis) continue;
        const Split best = snapped(a.args.costs, node.split, node.cell, a.nearest[c]);
        node.split =
            isWorthwhile(a.args.costs, best, node.cell, node.count, depth, a.state.maxDepth) ? best : noSplit();
    }
}

}  // namespace cleave::twin
