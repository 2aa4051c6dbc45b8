#version 460
// The best of a large node's bin boundaries by SAH, for `nearest` and `snap` to improve. An invocation per chunk; the
// first chunk of a node acts.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x = kGroup) in;

void main() {
    uint c = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (c >= thisLevel.chunkCount) return;
    uint n = args.chunks.at[c].node;
    BuildNodeArray nodes = nodesIn();
    BuildNode node = nodes.at[n];
    if (node.chunk != c) return;
    uint step = sampleStep(node.count, args.subsample != 0u);
    Split best = noSplit();
    for (uint axis = 0u; axis < 3u; axis++) {
        BinRange range = rangeOf(c, axis);
        uint counters = c * kBinWords + 2u * axis * kBins;
        // The ends of the range cut off empty space; what lies flat in them stays with the rest.
        best = betterOf(best, args.costs, node.cell, axis, range.lo, 0u, node.count, 0u);
        best = betterOf(best, args.costs, node.cell, axis, range.hi, node.count, 0u, 1u);
        if (!isResolved(range)) continue;
        uint left = 0u;
        uint right = ceilDiv(node.count, step);
        for (uint b = 1u; b < range.count; b++) {
            left += args.bins.at[counters + b - 1u];
            right -= args.bins.at[counters + kBins + b - 1u];
            best = betterOf(best, args.costs, node.cell, axis, binPlane(range, b), estimatedCount(left, step, node.count),
                            estimatedCount(right, step, node.count), 1u);
        }
    }
    nodes.at[n].split = best;
    args.nearest.at[c] = noFaces();
}
