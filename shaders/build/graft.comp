#version 460
// Moves the subtrees of each batch to their place in the tree. A workgroup per batch.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;

// `node` and `leafRef`: where the batch's nodes but for the roots go, and its leaf references.
KdNode placed(KdNode n, uint node, uint leafRef) {
    if (isLeaf(n)) return leafNode(leafRef + leafFirst(n), leafCount(n));
    return innerNode(nodeAxis(n), nodePosition(n), node + nodeChild(n));
}

void main() {
    uint batch = groupIndex();
    if (batch >= ceilDiv(thisLevel.subtreeRefCount, kBatch) || args.state.at.finish != 0u) return;
    Subtrees s = args.subtrees.at[batch];
    if (s.nodes == 0u) return;
    uvec4 before = args.blockSums.at[batch];
    uint node = args.state.at.subtreeNodes + before.z - s.roots;
    uint leafRef = args.state.at.subtreeRefs + before.w;
    uint i = gl_LocalInvocationID.x;
    BuildNodeArray nodes = nodesIn();
    for (uint n = s.firstNode + i; n < s.endNode; n += gl_WorkGroupSize.x) {
        if (nodes.at[n].split.axis != kSubtreeAxis) continue;
        args.tree.at[nodes.at[n].treeNode] = placed(args.stagedNodes.at[batch * kStagedNodes + nodes.at[n].child], node, leafRef);
    }
    for (uint k = s.roots + i; k < s.nodes; k += gl_WorkGroupSize.x) {
        args.tree.at[node + k] = placed(args.stagedNodes.at[batch * kStagedNodes + k], node, leafRef);
    }
    for (uint k = i; k < s.leafRefs; k += gl_WorkGroupSize.x) {
        args.leafRefs.at[leafRef + k] = args.stagedRefs.at[batch * kStagedRefs + k];
    }
    if (i == 0u) atomicMax(args.state.at.levels, push.depth + s.levels);
}
