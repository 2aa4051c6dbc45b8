#version 460
// Moves a large node's split to a face next to it where that is better, and keeps it if it is worth it. An invocation
// per chunk; the first chunk of a node acts.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"

layout(local_size_x = kGroup) in;

void main() {
    uint c = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (c >= thisLevel.chunkCount) return;
    uint n = args.chunks.at[c].node;
    BuildNodeArray nodes = nodesIn();
    BuildNode node = nodes.at[n];
    if (node.chunk != c || node.split.axis == kLeafAxis) return;
    Split best = snapped(args.costs, node.split, node.cell, args.nearest.at[c]);
    bool keep = isWorthwhile(args.costs, best, node.cell, node.count, push.depth, args.state.at.maxDepth);
    nodes.at[n].split = keep ? best : noSplit();
}
