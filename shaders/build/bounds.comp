#version 460
// Bounds of a large node's references, which its bins will span. A workgroup per chunk; clears the node's bins too.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;

shared uint lo[3];
shared uint hi[3];

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    uint i = gl_LocalInvocationID.x;
    Chunk chunk = args.chunks.at[c];
    BuildNode node = nodesIn().at[chunk.node];
    if (c == node.chunk) {
        for (uint k = i; k < kBinWords; k += gl_WorkGroupSize.x) args.bins.at[c * kBinWords + k] = 0u;
    }
    if (i < 3u) {
        lo[i] = 0xFFFFFFFFu;
        hi[i] = 0u;
    }
    meet();
    Box b = emptyBox();
    PrimRefArray refs = refsIn();
    for (uint k = i; k < chunk.count; k += gl_WorkGroupSize.x) {
        PrimRef r = refs.at[chunk.first + k];
        b = including(including(b, r.lo), r.hi);
    }
    if (i < chunk.count) {
        for (uint axis = 0u; axis < 3u; axis++) {
            atomicMin(lo[axis], orderedBits(b.lo[axis]));
            atomicMax(hi[axis], orderedBits(b.hi[axis]));
        }
    }
    meet();
    if (i < 3u) {
        atomicMin(args.bounds.at[node.chunk * kBoundsWords + i], lo[i]);
        atomicMax(args.bounds.at[node.chunk * kBoundsWords + 3u + i], hi[i]);
    }
}
