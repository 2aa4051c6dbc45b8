#version 460
// Copies a tree, without slack or to a larger capacity. Each invocation takes every so manyth entry, since how many there are is known on the
// device only.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/compact.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(push_constant, scalar) uniform Push { CompactPush push; };

// The address of a block of 16 bytes of the copy.
uvec2 addressOf(uint block) {
    uvec2 start = uvec2(push.to);
    uvec2 offset = bytesOfBlocks(block);
    uint carry;
    uint low = uaddCarry(start.x, offset.x, carry);
    return uvec2(low, start.y + offset.y + carry);
}

void main() {
    TreeData t = push.from.at;
    TreeLayout l = treeLayout(t.triangleCount, max(t.nodeCount, push.nodeCapacity), max(t.leafRefCount, push.leafRefCapacity));
    TreeTriangleArray triangles = TreeTriangleArray(addressOf(l.triangles));
    KdNodeArray nodes = KdNodeArray(addressOf(l.nodes));
    UintArray leafRefs = UintArray(addressOf(l.leafRefs));
    uint first = groupIndex() * kGroup + gl_LocalInvocationID.x;
    for (uint i = first; i < t.triangleCount; i += push.invocations) triangles.at[i] = t.triangles.at[i];
    for (uint i = first; i < t.nodeCount; i += push.invocations) nodes.at[i] = t.nodes.at[i];
    for (uint i = first; i < t.leafRefCount; i += push.invocations) leafRefs.at[i] = t.leafRefs.at[i];
    if (first != 0u) return;
    t.triangles = triangles;
    t.nodes = nodes;
    t.leafRefs = leafRefs;
    push.to.at = t;
}
