#include "twin/passes.h"

namespace cleave::twin {

// References arrive node by node, so the next level's list is: for each split node the left ones, then the right ones.
void partition(BuildArrays& a, uint32_t depth) {
    std::vector<PrimRef>& out = a.refsOut(depth);
    uint32_t next = 0;
    std::vector<Box> bounds(a.state.level[depth + 1].nodeCount, emptyBox());
    for (uint32_t n = 0; n < a.state.level[depth].nodeCount; n++) {
        const BuildNode& node = a.nodesIn(depth)[n];
        if (node.split.axis == kSubtreeAxis && node.child != kNone) continue;
        const KdNode emitted = a.tree[node.treeNode];
        const uint32_t child = nodeChild(emitted) - a.state.nodeBase;
        for (uint32_t side : {kLeft, kRight}) {
            for (uint32_t k = 0; k < node.count; k++) {
                const PrimRef& r = a.refsIn(depth)[node.first + k];
                const uint32_t sides = a.sides[node.first + k];
                if (isLeaf(emitted)) {
                    a.leafRefs[leafFirst(emitted) + k] = r.prim;
                } else if (sides & side) {
                    const Box box =
                        sides & kClipped ? a.clipped[2 * (node.first + k) + (side == kRight ? 1 : 0)] : Box{r.lo, r.hi};
                    out[next++] = PrimRef{box.lo, r.prim, box.hi, child + (side == kRight ? 1 : 0)};
                    Box& all = bounds[out[next - 1].node];
                    all = including(including(all, box.lo), box.hi);
                }
            }
        }
    }
    for (size_t n = 0; n < bounds.size(); n++) {
        const BuildNode& node = a.nodesOut(depth)[n];
        if (isLarge(node.count, a.args.exactUpTo)) setBounds(a, node.chunk, bounds[n]);
    }
}

}  // namespace cleave::twin
