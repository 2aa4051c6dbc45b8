#version 460
// Zeroes the counters of large nodes. A workgroup per chunk.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    for (uint k = gl_LocalInvocationID.x; k < kBinWords; k += gl_WorkGroupSize.x) args.bins.at[c * kBinWords + k] = 0u;
}
