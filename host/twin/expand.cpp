#include "twin/passes.h"

namespace cleave::twin {
namespace {

Box partIn(const BuildArrays& a, uint32_t prim, const Box& cell) {
    const Triangle triangle = withoutNumber(a.triangles[prim]);
    const Box box = intersection(triangleBox(triangle), cell);
    if (a.args.clip == 0) return box;
    const Box part = splitBoxes(triangle, box, 0, box.hi.x).left;
    return isEmpty(part) ? box : part;
}

}  // namespace

void expand(BuildArrays& a, uint32_t) {
    const uint32_t exactUpTo = a.args.exactUpTo;
    uint32_t refs = 0;
    uint32_t chunks = 0;
    for (uint32_t n = 0; n < a.args.openCount; n++) {
        const OpenLeaf& open = a.open[n];
        a.nodes0[n] = buildNode(open.cell, refs, open.count, open.treeNode, chunks);
        for (uint32_t c = 0; c < chunksOf(open.count, exactUpTo); c++)
            a.chunks[chunks + c] = chunkOf(n, refs, open.count, c);
        if (isLarge(open.count, exactUpTo)) setBounds(a, chunks, open.cell);
        for (uint32_t i = 0; i < open.count; i++) {
            const uint32_t prim = a.leafRefs[open.first + i];
            const Box box = partIn(a, prim, open.cell);
            a.refs0[refs++] = {box.lo, prim, box.hi, n};
        }
        chunks += chunksOf(open.count, exactUpTo);
    }
    a.state.nodesUsed = a.header.nodeCount;
    a.state.leafRefsUsed = a.header.leafRefCount;
    const uint32_t included = a.header.triangleCount - a.header.nonFinite - a.header.noArea;
    a.state.maxDepth = depthLimit(a.args.maxDepth, included) - a.args.openDepth;
    a.state.level[0] = levelOf(refs, a.args.openCount, chunks, 0, a.args.workers, a.args.row);
}

}  // namespace cleave::twin
