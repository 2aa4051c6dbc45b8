#version 460
// Which side each reference goes to, and how many of its block do so before it; straddling ones are clipped to both
// cells. A workgroup per block.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "lib/build.glsl"
#include "lib/clip.glsl"
#include "lib/group_sum.glsl"

layout(local_size_x_id = 0) in;

#include "lib/touch.glsl"

shared uint sides[kBlock];
shared uint straddling[kBlock];  // positions in the block; their order decides nothing
shared uint straddlingCount;

// The node that the invocation classifies references of: the next one's is mostly the same.
uint current = kNone;
Split split;

uint classified(uint index) {
    uint node = refsIn().at[index].node;
    if (node != current) {
        current = node;
        split = nodesIn().at[node].split;
    }
    if (split.axis >= kLeafAxis) return 0u;
    float lo = refsIn().at[index].lo[split.axis];
    float hi = refsIn().at[index].hi[split.axis];
    return sideOf(lo, hi, split.position, split.planarLeft);
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

// Left and right.
uvec4 countsOf(uint side) { return uvec4(side & kLeft, (side & kRight) >> 1, 0u, 0u); }

void main() {
    uint block = groupIndex();
    uint refCount = thisLevel.refCount;
    if (block >= ceilDiv(refCount, kBlock)) return;
    if (gl_LocalInvocationID.x == 0u) straddlingCount = 0u;
    meet();
    uint first = block * kBlock;
    uint count = min(kBlock, refCount - first);
    if (!touch(refsIn(), first, first + count, 1u)) return;
    for (uint k = gl_LocalInvocationID.x; k < count; k += gl_WorkGroupSize.x) {
        uint side = classified(first + k);
        sides[k] = side;
        if (side == (kLeft | kRight)) straddling[atomicAdd(straddlingCount, 1u)] = k;
    }
    meet();
    for (uint k = gl_LocalInvocationID.x; k < straddlingCount; k += gl_WorkGroupSize.x) {
        sides[straddling[k]] = clipped(first + straddling[k]);
    }
    meet();
    // An invocation adds up a run of consecutive ones.
    uint run = kBlock / gl_WorkGroupSize.x;
    uint from = min(count, gl_LocalInvocationID.x * run);
    uint to = min(count, from + run);
    uvec4 sum = uvec4(0u);
    for (uint k = from; k < to; k++) sum += countsOf(sides[k]);
    sum = sumBefore(sum, gl_WorkGroupSize.x);
    for (uint k = from; k < to; k++) {
        args.sides.at[first + k] = sideWord(sides[k], sum.x, sum.y);
        sum += countsOf(sides[k]);
    }
    if (gl_LocalInvocationID.x != gl_WorkGroupSize.x - 1u) return;
    args.blockSums.at[block].x = sum.x;
    args.blockSums.at[block].y = sum.y;
    if (block < ceilDiv(thisLevel.subtreeRefCount, kBatch)) return;
    args.blockSums.at[block].z = 0u;
    args.blockSums.at[block].w = 0u;
}
