#version 460
// Gathers the faces in the open bins of large nodes, those that are candidates. A workgroup per chunk, which looks at one
// axis after the other. The order of faces in a bin decides nothing.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "shared/face_bins.h"
layout(local_size_x_id = 0) in;

#include "lib/touch.glsl"

UintArray openBins;
Uvec2Array faces;

// `starts`: the first word of the axis.
void gather(FaceBins bins, uint starts, uint capacity, float x, uint kind) {
    uint word = starts + faceBinOf(bins, x);
    if (openBins.at[word] == kNone) return;
    faces.at[atomicAdd(openBins.at[word + capacity], 1u)] = uvec2(floatBitsToUint(x), kind);
}

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    Chunk chunk = args.chunks.at[c];
    BuildNode node = nodesIn().at[chunk.node];
    uint capacity = faceBinCapacity(node.count);
    PrimRefArray refs = refsIn();
    openBins = args.openBins;
    faces = args.workFaces;
    if (!touch(refs, chunk.first, chunk.first + chunk.count, 1u)) return;
    for (uint axis = 0u; axis < 3u; axis++) {
        uint openLo = args.bounds.at[node.chunk * kBoundsWords + axis];
        uint openHi = args.bounds.at[node.chunk * kBoundsWords + 3u + axis];
        if (openLo > openHi) continue;
        float first = fromOrderedBits(openLo);
        float last = fromOrderedBits(openHi);
        FaceBins bins = faceBins(node.cell, axis, capacity);
        uint starts = faceWord(node.chunk, capacity, axis, 0u);
        for (uint k = gl_LocalInvocationID.x; k < chunk.count; k += gl_WorkGroupSize.x) {
            float lo = refs.at[chunk.first + k].lo[axis];
            float hi = refs.at[chunk.first + k].hi[axis];
            bool takesLo = lo >= first && lo <= last && isInside(node.cell, axis, lo);
            bool takesHi = hi >= first && hi <= last && isInside(node.cell, axis, hi) && hi != lo;
            if (takesLo) gather(bins, starts, capacity, lo, lo == hi ? kFlatFace : kStartFace);
            if (takesHi) gather(bins, starts, capacity, hi, kEndFace);
        }
    }
}
