#version 460
// Gathers the faces in the open bins of large nodes, those that are candidates. A workgroup per chunk. Their order in a
// bin decides nothing.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
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
    uvec3 lo, hi;
    for (uint axis = 0u; axis < 3u; axis++) {
        lo[axis] = args.bounds.at[node.chunk * kBoundsWords + axis];
        hi[axis] = args.bounds.at[node.chunk * kBoundsWords + 3u + axis];
    }
    PrimRefArray refs = refsIn();
    for (uint k = gl_LocalInvocationID.x; k < chunk.count; k += gl_WorkGroupSize.x) {
        PrimRef r = refs.at[chunk.first + k];
        [[unroll]] for (uint side = 0u; side < 6u; side++) {
            uint axis = side >> 1;
            bool isUpper = (side & 1u) != 0u;
            float x = isUpper ? r.hi[axis] : r.lo[axis];
            if (orderedBits(x) < lo[axis] || orderedBits(x) > hi[axis]) continue;
            bool isFlat = r.lo[axis] == r.hi[axis];
            if ((isUpper && isFlat) || !isInside(node.cell, axis, x)) continue;
            uint word = faceWord(node.chunk, capacity, axis, faceBinOf(bins[axis], x));
            if (args.openBins.at[word] == kNone) continue;
            uint face = atomicAdd(args.openBins.at[word + capacity], 1u);
            args.workFaces.at[face] = uvec2(floatBitsToUint(x), isFlat ? kFlatFace : isUpper ? kEndFace : kStartFace);
        }
    }
}
