#include "twin/passes.h"

namespace cleave::twin {

namespace {

// One child: its node of the next level, its chunks, and the batch that begins there. `subtreeRefs`: how many
// references of nodes before it `subtrees` treats.
void emitChild(BuildArrays& a, uint32_t depth, uint32_t index, Box cell, uint32_t first, uint32_t count, uint32_t chunk,
               uint32_t subtreeRefs) {
    const uint32_t chunks = chunksOf(count, a.args.exactUpTo);
    a.nodesOut(depth)[index] = buildNode(cell, first, count, a.state.nodeBase + index, chunk);
    for (uint32_t c = 0; c < chunks; c++) a.chunks[chunk + c] = chunkOf(index, first, count, c);
    if (chunks > 0) setBounds(a, chunk, emptyBox());
    for (uint32_t r = 0; r < subtreeRefsOf(count, a.args.exactUpTo); r++)
        if ((subtreeRefs + r) % kBatch == 0) a.batchFirsts[(subtreeRefs + r) / kBatch] = r == 0 ? index : index + 1;
}

}  // namespace

void emitNodes(BuildArrays& a, uint32_t depth) {
    glm::uvec4 sums(0);
    for (uint32_t n = 0; n < a.state.level[depth].nodeCount; n++) {
        BuildNode& node = a.nodesIn(depth)[n];
        const Split& s = node.split;
        if (a.state.finish || s.axis == kLeafAxis) {
            const uint32_t first = a.state.leafBase + (a.state.finish ? node.first : sums.y);
            a.tree[node.treeNode] = leafNode(first, node.count);
            node.child = kNone;
            node.leftBase = first;
        } else if (s.axis != kSubtreeAxis) {
            const Children c = childrenOf(a, depth, node);
            const uint32_t upTo = a.args.exactUpTo;
            const uint32_t left = 2 * sums.x;
            const glm::uvec2 before = offsetsAt(a, depth, node.first);
            const uint32_t first = before.x + before.y;
            node.child = left;
            node.leftBase = before.y;
            node.rightBase = offsetsAt(a, depth, node.first + node.count).x;
            a.tree[node.treeNode] = innerNode(s.axis, s.position, a.state.nodeBase + left);
            emitChild(a, depth, left, leftOf(node.cell, s.axis, s.position), first, c.left, sums.z, sums.w);
            emitChild(a, depth, left + 1, rightOf(node.cell, s.axis, s.position), first + c.left, c.right,
                      sums.z + chunksOf(c.left, upTo), sums.w + subtreeRefsOf(c.left, upTo));
        }
        sums += nodeCounts(a, depth, node);
    }
}

}  // namespace cleave::twin
