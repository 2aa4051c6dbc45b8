#version 460
// Counts in which bins the references of large nodes begin and end: all of them. A workgroup per chunk, which looks at
// one axis after the other.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "shared/face_bins.h"
layout(local_size_x_id = 0) in;

#include "lib/touch.glsl"

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    Chunk chunk = args.chunks.at[c];
    BuildNode node = nodesIn().at[chunk.node];
    uint capacity = faceBinCapacity(node.count);
    PrimRefArray refs = refsIn();
    UintArray counters = args.bins;
    if (!touch(refs, chunk.first, chunk.first + chunk.count, 1u)) return;
    for (uint axis = 0u; axis < 3u; axis++) {
        FaceBins bins = faceBins(node.cell, axis, capacity);
        uint starts = faceWord(node.chunk, capacity, axis, 0u);
        uint ends = starts + capacity;
        for (uint k = gl_LocalInvocationID.x; k < chunk.count; k += gl_WorkGroupSize.x) {
            float lo = refs.at[chunk.first + k].lo[axis];
            float hi = refs.at[chunk.first + k].hi[axis];
            if (lo > bins.lo) atomicAdd(counters.at[starts + faceBinOf(bins, lo)], 1u);
            if (hi < bins.hi) atomicAdd(counters.at[ends + faceBinOf(bins, hi)], 1u);
        }
    }
}
