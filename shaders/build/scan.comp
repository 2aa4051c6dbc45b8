#version 460
// Exclusive prefix sums of block sums, in place, and their total. One workgroup: an invocation adds up a run of
// consecutive sums by itself, so that two barriers do (reduce, then scan).
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"

const uint kScanGroup = 256u;
layout(local_size_x = kScanGroup) in;

shared uvec4 runs[kScanGroup];

void main() {
    bool nodes = push.scans == kScanNodes;
    Uvec4Array sums = nodes ? args.nodeSums : args.blockSums;
    uint items = nodes ? thisLevel.nodeCount : push.scans == kScanRefs ? thisLevel.refCount : args.triangleCount;
    uint count = ceilDiv(items, kBlock);
    uint run = ceilDiv(count, kScanGroup);
    uint i = gl_LocalInvocationID.x;
    uint from = min(count, i * run);
    uint to = min(count, from + run);
    uvec4 sum = uvec4(0u);
    for (uint k = from; k < to; k++) sum += sums.at[k];
    runs[i] = sum;
    barrier();
    if (i == 0u) {
        uvec4 total = uvec4(0u);
        for (uint k = 0u; k < kScanGroup; k++) {
            uvec4 next = runs[k];
            runs[k] = total;
            total += next;
        }
        if (nodes) args.state.at.nodeTotals = total;
        else args.state.at.refTotals = total;
    }
    barrier();
    sum = runs[i];
    for (uint k = from; k < to; k++) {
        uvec4 next = sums.at[k];
        sums.at[k] = sum;
        sum += next;
    }
}
