#version 460
// The best of a large node's bin boundaries by SAH, for `nearest` and `snap` to improve; without these the split itself,
// if it is worth it. Leaves the counters at 0. A workgroup per chunk, of any size that is a power of two; that of a node's
// first chunk acts.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;

shared uint sums[kBinWords];  // of starts and of ends, up to and with each bin: laid out as the counters
shared Split bests[kLargestGroup];

void sumUp(uint chunk, uint list) {
    uint sum = 0u;
    for (uint b = 0u; b < args.binCount; b++) {
        sum += args.bins.at[chunk * kBinWords + list * kBins + b];
        sums[list * kBins + b] = sum;
    }
}

// With the plane at which bin b begins; bins count every `step`-th reference.
Split withBoundary(Split best, BuildNode node, BinRange range, uint axis, uint b, uint step) {
    if (b == 0u) {
        // The ends of the range cut off empty space; what lies flat in them stays with the rest.
        best = betterOf(best, args.costs, node.cell, axis, range.lo, 0u, node.count, 0u);
        return betterOf(best, args.costs, node.cell, axis, range.hi, node.count, 0u, 1u);
    }
    if (!isResolved(range)) return best;
    uint left = sums[2u * axis * kBins + b - 1u];
    uint right = ceilDiv(node.count, step) - sums[(2u * axis + 1u) * kBins + b - 1u];
    return betterOf(best, args.costs, node.cell, axis, binPlane(range, b), estimatedCount(left, step, node.count),
                    estimatedCount(right, step, node.count), 1u);
}

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    uint n = args.chunks.at[c].node;
    BuildNodeArray nodes = nodesIn();
    BuildNode node = nodes.at[n];
    if (node.chunk != c) return;
    uint i = gl_LocalInvocationID.x;
    if (i < 6u) sumUp(c, i);
    meet();
    for (uint k = i; k < kBinWords; k += gl_WorkGroupSize.x) args.bins.at[c * kBinWords + k] = 0u;
    uint step = sampleStep(node.count, args.subsample != 0u);
    Split best = noSplit();
    for (uint axis = 0u; axis < 3u; axis++) {
        BinRange range = rangeOf(c, axis);
        for (uint b = i; b < range.count; b += gl_WorkGroupSize.x) best = withBoundary(best, node, range, axis, b, step);
    }
    bests[i] = best;
    for (uint others = gl_WorkGroupSize.x / 2u; others > 0u; others /= 2u) {
        meet();
        if (i < others && isBetter(bests[i + others], bests[i])) bests[i] = bests[i + others];
    }
    if (i != 0u) return;
    best = bests[0];
    bool keep = args.snap != 0u || isWorthwhile(args.costs, best, node.cell, node.count, push.depth, args.state.at.maxDepth);
    nodes.at[n].split = keep ? best : noSplit();
    args.nearest.at[c] = noFaces();
}
