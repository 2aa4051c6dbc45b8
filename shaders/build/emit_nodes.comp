#version 460
// Writes the tree's nodes of this level and the lists of nodes, of chunks and of batches of the next. A workgroup per
// block of nodes; an invocation treats a run of consecutive ones.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/group_sum.glsl"
#include "lib/children.glsl"

layout(local_size_x_id = 0) in;

// One child: its node of the next level, its chunks, and the batch that begins there. `subtreeRefs`: how many references
// of nodes before it `subtrees` treats.
void emitChild(uint index, Box cell, uint first, uint count, uint chunk, uint subtreeRefs) {
    nodesOut().at[index] = buildNode(cell, first, count, args.state.at.nodeBase + index, chunk);
    uint chunks = chunksOf(count, args.exactUpTo);
    for (uint c = 0u; c < chunks; c++) args.chunks.at[chunk + c] = chunkOf(index, first, count, c);
    if (chunks > 0u) setBounds(chunk, emptyBox());  // `partition` includes references
    uint batch = batchAt(subtreeRefs, subtreeRefsOf(count, args.exactUpTo));
    if (batch != kNone) args.batchFirsts.at[batch] = batch * kBatch == subtreeRefs ? index : index + 1u;
}

void emitLeaf(uint index, BuildNode node, uint first) {
    args.tree.at[node.treeNode] = leafNode(first, node.count);
    nodesIn().at[index].child = kNone;
    nodesIn().at[index].leftBase = first;
}

// `before`: the totals of the nodes before this one.
void emitNode(uint index, BuildNode node, uvec2 children, uvec4 before) {
    Split s = node.split;
    if (s.axis == kSubtreeAxis) return;
    if (s.axis == kLeafAxis) {
        emitLeaf(index, node, args.state.at.leafBase + before.y);
        return;
    }
    uint left = 2u * before.x;
    args.tree.at[node.treeNode] = innerNode(s.axis, s.position, args.state.at.nodeBase + left);
    // The children of a node lie one after the other, where the left and right references before the node end.
    uvec2 offset = offsetsAt(node.first);
    uint first = offset.x + offset.y;
    nodesIn().at[index].child = left;
    nodesIn().at[index].leftBase = offset.y;
    nodesIn().at[index].rightBase = offsetsAt(node.first + node.count).x;
    emitChild(left, leftOf(node.cell, s.axis, s.position), first, children.x, before.z, before.w);
    emitChild(left + 1u, rightOf(node.cell, s.axis, s.position), first + children.x, children.y,
              before.z + chunksOf(children.x, args.exactUpTo), before.w + subtreeRefsOf(children.x, args.exactUpTo));
}

void main() {
    uint block = groupIndex();
    uint nodeCount = thisLevel.nodeCount;
    if (block >= ceilDiv(nodeCount, kBlock)) return;
    uint i = gl_LocalInvocationID.x;
    uint run = kBlock / gl_WorkGroupSize.x;
    uint from = block * kBlock + i * run;
    uint to = min(from + run, nodeCount);
    if (args.state.at.finish != 0u) {
        for (uint k = from; k < to; k++) {
            BuildNode node = nodesIn().at[k];
            emitLeaf(k, node, args.state.at.leafBase + node.first);
        }
        return;
    }
    uvec4 sum = uvec4(0u);
    for (uint k = from; k < to; k++) {
        BuildNode node = nodesIn().at[k];
        sum += nodeCounts(node, childCounts(node));
    }
    sum = args.nodeSums.at[block] + sumBefore(sum, gl_WorkGroupSize.x);
    for (uint k = from; k < to; k++) {
        BuildNode node = nodesIn().at[k];
        uvec2 children = childCounts(node);
        emitNode(k, node, children, sum);
        sum += nodeCounts(node, children);
    }
}
