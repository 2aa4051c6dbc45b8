#version 460
// The faces of boxes next to a large node's split, and the counts there. A workgroup per chunk.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"

layout(local_size_x_id = 0) in;

#include "lib/touch.glsl"

shared NearestFaces faces;

void main() {
    uint c = groupIndex();
    if (c >= thisLevel.chunkCount) return;
    uint i = gl_LocalInvocationID.x;
    Chunk chunk = args.chunks.at[c];
    BuildNode node = nodesIn().at[chunk.node];
    uint axis = node.split.axis;
    if (axis == kLeafAxis) return;
    if (i == 0u) faces = noFaces();
    meet();
    NearestFaces mine = noFaces();
    PrimRefArray refs = refsIn();
    if (!touch(refs, chunk.first, chunk.first + chunk.count, 1u)) return;
    for (uint k = i; k < chunk.count; k += gl_WorkGroupSize.x) {
        float lo = refs.at[chunk.first + k].lo[axis];
        float hi = refs.at[chunk.first + k].hi[axis];
        mine = including(mine, lo, hi, node.split.position);
    }
    atomicMax(faces.below, mine.below);
    atomicMin(faces.above, mine.above);
    atomicAdd(faces.left, mine.left);
    atomicAdd(faces.rightBelow, mine.rightBelow);
    atomicAdd(faces.right, mine.right);
    atomicAdd(faces.planar, mine.planar);
    meet();
    if (i != 0u) return;
    atomicMax(args.nearest.at[node.chunk].below, faces.below);
    atomicMin(args.nearest.at[node.chunk].above, faces.above);
    atomicAdd(args.nearest.at[node.chunk].left, faces.left);
    atomicAdd(args.nearest.at[node.chunk].rightBelow, faces.rightBelow);
    atomicAdd(args.nearest.at[node.chunk].right, faces.right);
    atomicAdd(args.nearest.at[node.chunk].planar, faces.planar);
}
