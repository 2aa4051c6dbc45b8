#version 460
// Counts in which bins the references of large nodes begin and end: all of them. A workgroup per chunk.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "shared/face_bins.h"
layout(local_size_x_id = 0) in;

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    Chunk chunk = args.chunks.at[c];
    BuildNode node = nodesIn().at[chunk.node];
    uint capacity = faceBinCapacity(node.count);
    FaceBins bins[3];
    for (uint axis = 0u; axis < 3u; axis++) bins[axis] = faceBins(node.cell, axis, capacity);
    PrimRefArray refs = refsIn();
    for (uint k = gl_LocalInvocationID.x; k < chunk.count; k += gl_WorkGroupSize.x) {
        PrimRef r = refs.at[chunk.first + k];
        for (uint axis = 0u; axis < 3u; axis++) {
            uint starts = faceWord(node.chunk, capacity, axis, 0u);
            uint ends = starts + capacity;
            if (r.lo[axis] > node.cell.lo[axis]) atomicAdd(args.bins.at[starts + faceBinOf(bins[axis], r.lo[axis])], 1u);
            if (r.hi[axis] < node.cell.hi[axis]) atomicAdd(args.bins.at[ends + faceBinOf(bins[axis], r.hi[axis])], 1u);
        }
    }
}
