#version 460
// Exclusive prefix sums of the sums of blocks, of references or, before the first level, of triangles, in place, and
// their total. One workgroup.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/scan.glsl"
layout(local_size_x = kLargestGroup) in;

void main() {
    uint items = push.scans == kScanRefs ? thisLevel.refCount : args.triangleCount;
    uvec4 total = scanInPlace(args.blockSums, ceilDiv(items, kBlock), kLargestGroup);
    if (gl_LocalInvocationID.x == kLargestGroup - 1u) args.state.at.refTotals = total;
}
