#version 460
// Exclusive prefix sums of the sums of blocks, of references or, before the first level, of triangles, in place, and
// their total. One workgroup.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/scan.glsl"
layout(local_size_x_id = 0) in;

void main() {
    uint items = push.scans == kScanRefs ? thisLevel.refCount : args.triangleCount;
    uvec4 total = scanInPlace(args.blockSums, ceilDiv(items, kBlock), gl_WorkGroupSize.x);
    if (gl_LocalInvocationID.x == gl_WorkGroupSize.x - 1u) args.state.at.refTotals = total;
}
