#version 460
// Finds the largest coordinate of all finite vertices, which decides the scale of the tree. A workgroup per block of
// triangles.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/geometry.glsl"
layout(local_size_x_id = 0) in;

shared uint largest;

void main() {
    uint block = groupIndex();
    if (block >= ceilDiv(args.triangleCount, kBlock)) return;
    if (gl_LocalInvocationID.x == 0u) largest = 0u;
    meet();
    uint first = block * kBlock;
    uint count = min(kBlock, args.triangleCount - first);
    uint mine = 0u;
    for (uint k = gl_LocalInvocationID.x; k < count; k += gl_WorkGroupSize.x) {
        Triangle t = worldTriangle(triangleNumber(first + k));
        mine = max(mine, max(reachOf(t.a), max(reachOf(t.b), reachOf(t.c))));
    }
    atomicMax(largest, mine);
    meet();
    if (gl_LocalInvocationID.x == 0u) atomicMax(args.state.at.scene.largest, largest);
}
