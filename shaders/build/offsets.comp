#version 460
// How many left and right references lie before each reference of the level. A workgroup per block; an invocation
// adds up a run of consecutive ones.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/group_sum.glsl"

layout(local_size_x_id = 0) in;

uvec2 countsOf(uint side) { return uvec2(side & kLeft, (side & kRight) >> 1); }

void main() {
    uint block = groupIndex();
    uint refCount = thisLevel.refCount;
    if (block >= ceilDiv(refCount, kBlock)) return;
    uint i = gl_LocalInvocationID.x;
    uint run = kBlock / gl_WorkGroupSize.x;
    uint from = block * kBlock + i * run;
    uint to = min(from + run, refCount);
    uvec2 sum = uvec2(0u);
    for (uint k = from; k < to; k++) sum += countsOf(args.sides.at[k]);
    uvec4 before = args.blockSums.at[block] + sumBefore(uvec4(sum.x, sum.y, 0u, 0u), gl_WorkGroupSize.x);
    sum = uvec2(before.x, before.y);
    for (uint k = from; k < to; k++) {
        args.offsets.at[k] = sum;
        sum += countsOf(args.sides.at[k]);
    }
    if (to == refCount && from < to) args.offsets.at[refCount] = sum;
}
