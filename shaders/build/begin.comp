#version 460
// Begins the first level: one node, the root, with all references. One invocation.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x = 1) in;

void main() {
    uint n = args.state.at.refTotals.x;
    uint chunks = chunksOf(n, args.exactUpTo);
    args.state.at.scene.included = n;
    args.nodes0.at[0] = buildNode(rootCell(args.state.at.scene), 0u, n, 0u, 0u);
    for (uint c = 0u; c < chunks; c++) args.chunks.at[c] = chunkOf(0u, 0u, n, c);
    if (chunks > 0u) setBounds(0u, args.nodes0.at[0].cell);
    args.state.at.nodesUsed = 1u;
    args.state.at.maxDepth = depthLimit(args.maxDepth, n);
    args.batchFirsts.at[0] = 0u;
    args.state.at.level[0] = levelOf(n, 1u, chunks, subtreeRefsOf(n, args.exactUpTo), args.workers, args.row);
}
