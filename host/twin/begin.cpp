#include "twin/passes.h"

namespace cleave::twin {

void setBounds(BuildArrays& a, uint32_t chunk, Box bounds) {
    for (int axis = 0; axis < 3; axis++) {
        uint32_t* const words = &a.bounds[chunk * kBoundsWords + static_cast<uint32_t>(axis)];
        words[0] = orderedBits(bounds.lo[axis]);
        words[3] = orderedBits(bounds.hi[axis]);
    }
}

void begin(BuildArrays& a, uint32_t) {
    const uint32_t n = a.state.refTotals.x;
    const uint32_t chunks = chunksOf(n, a.args.exactUpTo);
    a.state.scene.included = n;
    a.nodes0[0] = buildNode(rootCell(a.state.scene), 0, n, 0, 0);
    for (uint32_t c = 0; c < chunks; c++) a.chunks[c] = chunkOf(0, 0, n, c);
    if (chunks > 0) setBounds(a, 0, a.nodes0[0].cell);
    a.state.nodesUsed = 1;
    a.state.maxDepth = depthLimit(a.args.maxDepth, n);
    a.batchFirsts[0] = 0;
    a.state.level[0] = levelOf(n, 1, chunks, subtreeRefsOf(n, a.args.exactUpTo), a.args.workers, a.args.row);
}

}  // namespace cleave::twin
