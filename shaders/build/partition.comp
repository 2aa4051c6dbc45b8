#version 460
// Moves each reference to its place in the next level, or into its leaf's list; stable. An invocation per reference.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"

layout(local_size_x = kGroup) in;

void place(uint index, uint prim, Box box, uint node) {
    PrimRef r;
    r.lo = box.lo;
    r.prim = prim;
    r.hi = box.hi;
    r.node = node;
    refsOut().at[index] = r;
}

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= thisLevel.refCount) return;
    PrimRef r = refsIn().at[i];
    BuildNode node = nodesIn().at[r.node];
    if (node.child == kNone) {
        args.leafRefs.at[node.leftBase + i - node.first] = r.prim;
        return;
    }
    uint side = args.sides.at[i];
    uvec2 before = args.offsets.at[i];
    Box left;
    left.lo = r.lo;
    left.hi = r.hi;
    Box right = left;
    if ((side & kClipped) != 0u) {
        left = args.clipped.at[2u * i];
        right = args.clipped.at[2u * i + 1u];
    }
    if ((side & kLeft) != 0u) place(node.leftBase + before.x, r.prim, left, node.child);
    if ((side & kRight) != 0u) place(node.rightBase + before.y, r.prim, right, node.child + 1u);
}
