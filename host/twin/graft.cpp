#include "twin/passes.h"

namespace cleave::twin {

void graft(BuildArrays& a, uint32_t depth) {
    if (a.state.finish) return;
    for (uint32_t batch = 0; batch < ceilDiv(a.state.level[depth].subtreeRefCount, kBatch); batch++) {
        const Subtrees& s = a.subtrees[batch];
        if (s.nodes == 0) continue;
        const uint32_t node = a.state.subtreeNodes + a.blockSums[batch].z;
        const uint32_t leafRef = a.state.subtreeRefs + a.blockSums[batch].w;
        const KdNode* nodes = &a.stagedNodes[size_t{batch} * kStagedNodes];
        const uint32_t* leafRefs = &a.stagedRefs[size_t{batch} * kStagedRefs];
        const auto placed = [&](KdNode n) {
            if (isLeaf(n)) return leafNode(leafRef + leafFirst(n), leafCount(n));
            return innerNode(nodeAxis(n), nodePosition(n), node + nodeChild(n) - s.roots);
        };
        for (uint32_t n = s.firstNode; n < s.endNode; n++) {
            const BuildNode& root = a.nodesIn(depth)[n];
            if (root.split.axis == kSubtreeAxis) a.tree[root.treeNode] = placed(nodes[root.child]);
        }
        for (uint32_t k = s.roots; k < s.nodes; k++) a.tree[node + k - s.roots] = placed(nodes[k]);
        for (uint32_t k = 0; k < s.leafRefs; k++) a.leafRefs[leafRef + k] = leafRefs[k];
        a.state.levels = std::max(a.state.levels, depth + s.levels);
    }
}

}  // namespace cleave::twin
