#version 460
// Moves each reference to its place in the next level, or into its leaf's list; stable. A workgroup per block. Those that
// were clipped, which go to two places, are treated after the others.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"

layout(local_size_x_id = 0) in;

shared uint clipped[kBlock];  // positions in the block; their order decides nothing
shared uint clippedCount;

void place(uint index, uint prim, Box box, uint node) {
    PrimRef r;
    r.lo = box.lo;
    r.prim = prim;
    r.hi = box.hi;
    r.node = node;
    refsOut().at[index] = r;
}

void moveWhole(uint i, uint side) {
    PrimRef r = refsIn().at[i];
    BuildNode node = nodesIn().at[r.node];
    if (node.child == kNone) {
        args.leafRefs.at[node.leftBase + i - node.first] = r.prim;
        return;
    }
    if (side == 0u) return;  // its node is built already
    uvec2 before = args.offsets.at[i];
    Box box;
    box.lo = r.lo;
    box.hi = r.hi;
    bool isLeft = side == kLeft;
    place(isLeft ? node.leftBase + before.x : node.rightBase + before.y, r.prim, box, isLeft ? node.child : node.child + 1u);
}

void moveParts(uint i) {
    uint side = args.sides.at[i];
    uint prim = refsIn().at[i].prim;
    BuildNode node = nodesIn().at[refsIn().at[i].node];
    uvec2 before = args.offsets.at[i];
    if ((side & kLeft) != 0u) place(node.leftBase + before.x, prim, args.clipped.at[2u * i], node.child);
    if ((side & kRight) != 0u) place(node.rightBase + before.y, prim, args.clipped.at[2u * i + 1u], node.child + 1u);
}

void main() {
    uint block = groupIndex();
    uint refCount = thisLevel.refCount;
    if (block >= ceilDiv(refCount, kBlock)) return;
    if (gl_LocalInvocationID.x == 0u) clippedCount = 0u;
    meet();
    uint first = block * kBlock;
    uint count = min(kBlock, refCount - first);
    bool leaves = args.state.at.finish != 0u;  // all nodes become leaves, whatever side references were to go to
    for (uint k = gl_LocalInvocationID.x; k < count; k += gl_WorkGroupSize.x) {
        uint side = args.sides.at[first + k];
        if ((side & kClipped) != 0u && !leaves) {
            clipped[atomicAdd(clippedCount, 1u)] = k;
        } else {
            moveWhole(first + k, side);
        }
    }
    meet();
    for (uint k = gl_LocalInvocationID.x; k < clippedCount; k += gl_WorkGroupSize.x) moveParts(first + clipped[k]);
}
