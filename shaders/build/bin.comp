#version 460
// Min-max binning (Shevtsov et al. 2007): counts where references start and end. A workgroup per chunk.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;

#include "lib/touch.glsl"

// Lanes that run in lockstep count by themselves: to add atomically costs a CPU more.
const uint kColumns = kLockstep ? gl_WorkGroupSize.x : 1u;
shared uint counters[kBinWords * kColumns];

void count(uint counter) {
    if (kLockstep)
        counters[counter * kColumns + gl_LocalInvocationID.x]++;
    else
        atomicAdd(counters[counter], 1u);
}

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    uint i = gl_LocalInvocationID.x;
    Chunk chunk = args.chunks.at[c];
    BuildNode node = nodesIn().at[chunk.node];
    uint slot = node.chunk;
    uint step = sampleStep(node.count, args.subsample != 0u);
    uint first = (step - (chunk.first - node.first) % step) % step;  // every step-th of the node, not of the chunk
    for (uint k = i; k < kBinWords * kColumns; k += gl_WorkGroupSize.x) counters[k] = 0u;
    BinRange ranges[3];
    for (uint axis = 0u; axis < 3u; axis++) ranges[axis] = rangeOf(slot, axis);
    meet();
    PrimRefArray refs = refsIn();
    if (!touch(refs, chunk.first + first, chunk.first + chunk.count, step)) return;
    for (uint k = first + i * step; k < chunk.count; k += gl_WorkGroupSize.x * step) {
        PrimRef r = refs.at[chunk.first + k];
        for (uint axis = 0u; axis < 3u; axis++) {
            if (!isBinned(ranges[axis], args.everything != 0u)) continue;
            uint base = 2u * axis * kBins;
            count(base + startBin(ranges[axis], r.lo[axis], r.hi[axis]));
            count(base + kBins + endBin(ranges[axis], r.hi[axis]));
        }
    }
    meet();
    for (uint k = i; k < kBinWords; k += gl_WorkGroupSize.x) {
        uint sum = 0u;
        for (uint column = 0u; column < kColumns; column++) sum += counters[k * kColumns + column];
        if (sum != 0u) atomicAdd(args.bins.at[slot * kBinWords + k], sum);
    }
}
