#version 460
// Makes the references of the root: a box for each triangle in the tree, in the order of their numbers. A workgroup per
// block of triangles; an invocation treats a run of consecutive ones.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/group_sum.glsl"
layout(local_size_x_id = 0) in;

void main() {
    uint block = groupIndex();
    if (block >= ceilDiv(args.triangleCount, kBlock)) return;
    uint i = gl_LocalInvocationID.x;
    uint run = kBlock / gl_WorkGroupSize.x;
    uint from = block * kBlock + i * run;
    uint to = min(from + run, args.triangleCount);
    uint sum = 0u;
    for (uint k = from; k < to; k++) sum += args.sides.at[k];
    sum = args.blockSums.at[block].x + sumBefore(uvec4(sum, 0u, 0u, 0u), gl_WorkGroupSize.x).x;
    for (uint k = from; k < to; k++) {
        if (args.sides.at[k] == 0u) continue;
        Box b = triangleBox(withoutNumber(args.triangles.at[k]));
        PrimRef r;
        r.lo = b.lo;
        r.prim = k;
        r.hi = b.hi;
        r.node = 0u;
        args.refs0.at[sum] = r;
        sum++;
    }
}
