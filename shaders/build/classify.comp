#version 460
// Which side each reference goes to; straddling ones are clipped to both cells. A workgroup per block.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "lib/build.glsl"
#include "lib/clip.glsl"

layout(local_size_x_id = 0) in;

shared uint straddling[kBlock];  // positions in the block; their order decides nothing
shared uint straddlingCount;
shared uint leftCount;
shared uint rightCount;

uint classified(PrimRef r) {
    Split s = nodesIn().at[r.node].split;
    if (s.axis >= kLeafAxis) return 0u;
    return sideOf(r.lo[s.axis], r.hi[s.axis], s.position, s.planarLeft);
}

// Stores the boxes of both parts; the sides that they leave.
uint clipped(uint index) {
    PrimRef r = refsIn().at[index];
    BuildNode node = nodesIn().at[r.node];
    Box box;
    box.lo = r.lo;
    box.hi = r.hi;
    SplitBoxes parts;
    if (args.clip != 0u) {
        parts = partsOf(withoutNumber(args.triangles.at[r.prim]), box, node.split.axis, node.split.position);
    } else {
        parts.left = leftOf(box, node.split.axis, node.split.position);
        parts.right = rightOf(box, node.split.axis, node.split.position);
    }
    args.clipped.at[2u * index] = parts.left;
    args.clipped.at[2u * index + 1u] = parts.right;
    return kClipped | (isEmpty(parts.left) ? 0u : kLeft) | (isEmpty(parts.right) ? 0u : kRight);
}

void main() {
    uint block = groupIndex();
    uint refCount = thisLevel.refCount;
    if (block >= ceilDiv(refCount, kBlock)) return;
    if (gl_LocalInvocationID.x == 0u) {
        straddlingCount = 0u;
        leftCount = 0u;
        rightCount = 0u;
    }
    meet();
    uint first = block * kBlock;
    uint count = min(kBlock, refCount - first);
    uint left = 0u;
    uint right = 0u;
    for (uint k = gl_LocalInvocationID.x; k < count; k += gl_WorkGroupSize.x) {
        uint side = classified(refsIn().at[first + k]);
        if (side == (kLeft | kRight)) {
            straddling[atomicAdd(straddlingCount, 1u)] = k;
        } else {
            args.sides.at[first + k] = side;
            left += side & kLeft;
            right += side >> 1;
        }
    }
    meet();
    for (uint k = gl_LocalInvocationID.x; k < straddlingCount; k += gl_WorkGroupSize.x) {
        uint index = first + straddling[k];
        uint side = clipped(index);
        args.sides.at[index] = side;
        left += side & kLeft;
        right += (side & kRight) >> 1;
    }
    atomicAdd(leftCount, left);
    atomicAdd(rightCount, right);
    meet();
    if (gl_LocalInvocationID.x != 0u) return;
    args.blockSums.at[block].x = leftCount;
    args.blockSums.at[block].y = rightCount;
    if (block < ceilDiv(thisLevel.subtreeRefCount, kBatch)) return;
    args.blockSums.at[block].z = 0u;
    args.blockSums.at[block].w = 0u;
}
