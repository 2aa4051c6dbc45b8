#version 460
// Sums over each block of nodes what nodeCounts() tells.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/children.glsl"

layout(local_size_x_id = 0) in;

shared uint sums[4];

void main() {
    uint block = groupIndex();
    uint nodeCount = thisLevel.nodeCount;
    if (block >= ceilDiv(nodeCount, kBlock)) return;
    uint i = gl_LocalInvocationID.x;
    if (i < 4u) sums[i] = 0u;
    meet();
    uint first = block * kBlock;
    uint count = min(kBlock, nodeCount - first);
    uvec4 sum = uvec4(0u);
    for (uint k = i; k < count; k += gl_WorkGroupSize.x) {
        BuildNode node = nodesIn().at[first + k];
        sum += nodeCounts(node, childCounts(node));
    }
    for (uint k = 0u; k < 4u; k++) atomicAdd(sums[k], sum[k]);
    meet();
    if (i == 0u) args.nodeSums.at[block] = uvec4(sums[0], sums[1], sums[2], sums[3]);
}
