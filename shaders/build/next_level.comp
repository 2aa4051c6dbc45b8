#version 460
// Prefix sums of the sums of blocks of nodes, and from their total whether the next level fits, and how large it is.
// One workgroup.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/scan.glsl"
layout(local_size_x_id = 0) in;

void main() {
    uvec4 totals = scanInPlace(args.nodeSums, ceilDiv(thisLevel.nodeCount, kBlock), gl_WorkGroupSize.x);
    if (gl_LocalInvocationID.x != gl_WorkGroupSize.x - 1u) return;
    uint refs = args.state.at.refTotals.x + args.state.at.refTotals.y;
    uvec2 ofSubtrees = uvec2(args.state.at.refTotals.z, args.state.at.refTotals.w);
    uint nodes = args.state.at.nodesUsed + 2u * totals.x + ofSubtrees.x;
    // All references of the next level may end in leaves: they must fit there, too.
    uint leafRefs = args.state.at.leafRefsUsed + totals.y + ofSubtrees.y + refs;
    uint levelNodes = 2u * totals.x;
    bool fits = refs <= args.refCapacity && levelNodes <= args.levelNodeCapacity && nodes <= args.nodeCapacity && leafRefs <= args.leafRefCapacity;
    if (refs > args.refCapacity) args.state.at.neededRefs = refs;
    if (levelNodes > args.levelNodeCapacity) args.state.at.neededLevelNodes = levelNodes;
    if (nodes > args.nodeCapacity) args.state.at.neededNodes = nodes;
    if (leafRefs > args.leafRefCapacity) args.state.at.neededLeafRefs = leafRefs;
    args.state.at.finish = fits ? 0u : 1u;
    args.state.at.levels = max(args.state.at.levels, push.depth + 1u);
    args.state.at.nodeBase = args.state.at.nodesUsed;
    args.state.at.leafBase = args.state.at.leafRefsUsed;
    args.state.at.batchesTaken = 0u;
    args.state.at.subtreeNodes = args.state.at.nodeBase + 2u * totals.x;
    args.state.at.subtreeRefs = args.state.at.leafBase + totals.y;
    if (fits) {
        args.state.at.nodesUsed = nodes;
        args.state.at.leafRefsUsed += totals.y + ofSubtrees.y;
        bool last = push.depth + 1u >= args.state.at.maxDepth;  // its nodes are leaves: there is nothing to choose
        args.state.at.level[push.depth + 1u] = levelOf(refs, levelNodes, last ? 0u : totals.z, last ? 0u : totals.w, args.workers, args.row);
    } else {
        args.state.at.leafRefsUsed += thisLevel.refCount;
        args.state.at.level[push.depth + 1u] = levelOf(0u, 0u, 0u, 0u, 0u, args.row);
    }
}
