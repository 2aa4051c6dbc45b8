#version 460
// The references of the root: a box for each included triangle. An invocation per triangle.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x = kGroup) in;

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= args.includedCount) return;
    uint prim = args.included.at[i];
    Triangle t = args.triangles.at[prim];
    Box b = triangleBox(t);
    PrimRef r;
    r.lo = b.lo;
    r.prim = prim;
    r.hi = b.hi;
    r.node = 0u;
    args.refs0.at[i] = r;
}
