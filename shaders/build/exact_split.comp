#version 460
// Exact SAH of a small node: every face of every box is a candidate. A workgroup per node, of any size.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;

shared Split bests[64];

void main() {
    uint s = groupIndex();
    if (s >= thisLevel.smallCount) return;
    uint n = args.smallNodes.at[s];
    BuildNodeArray nodes = nodesIn();
    BuildNode node = nodes.at[n];
    PrimRefArray refs = refsIn();
    Split best = noSplit();
    for (uint k = gl_LocalInvocationID.x; k < node.count; k += gl_WorkGroupSize.x) {
        PrimRef r = refs.at[node.first + k];
        uvec3 loLeft = uvec3(0u);
        uvec3 loRight = uvec3(0u);
        uvec3 loPlanar = uvec3(0u);
        uvec3 hiLeft = uvec3(0u);
        uvec3 hiRight = uvec3(0u);
        uvec3 hiPlanar = uvec3(0u);
        bool anyFlat = false;
        for (uint j = 0u; j < node.count; j++) {
            PrimRef o = refs.at[node.first + j];
            loLeft += uvec3(lessThan(o.lo, r.lo));
            loRight += uvec3(greaterThan(o.hi, r.lo));
            hiLeft += uvec3(lessThan(o.lo, r.hi));
            hiRight += uvec3(greaterThan(o.hi, r.hi));
            anyFlat = anyFlat || any(equal(o.lo, o.hi));
        }
        for (uint j = 0u; anyFlat && j < node.count; j++) {  // rare
            PrimRef o = refs.at[node.first + j];
            uvec3 isFlat = uvec3(equal(o.lo, o.hi));
            loPlanar += isFlat * uvec3(equal(o.lo, r.lo));
            hiPlanar += isFlat * uvec3(equal(o.lo, r.hi));
        }
        for (uint axis = 0u; axis < 3u; axis++) {
            best = betterOfBothSides(best, args.costs, node.cell, axis, r.lo[axis], loLeft[axis], loRight[axis], loPlanar[axis]);
            best = betterOfBothSides(best, args.costs, node.cell, axis, r.hi[axis], hiLeft[axis], hiRight[axis], hiPlanar[axis]);
        }
    }
    bests[gl_LocalInvocationID.x] = best;
    barrier();
    if (gl_LocalInvocationID.x != 0u) return;
    uint entries = min(node.count, gl_WorkGroupSize.x);
    for (uint k = 1u; k < entries; k++) {
        if (isBetter(bests[k], best)) best = bests[k];
    }
    if (isWorthwhile(args.costs, best, node.cell, node.count, push.depth, args.state.at.maxDepth)) nodes.at[n].split = best;
}
