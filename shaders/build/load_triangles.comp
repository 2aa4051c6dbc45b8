#version 460
// Scales each triangle into the tree, and marks those that the tree is built over: all but the ones that are not finite
// or have no area. A workgroup per block of triangles.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
#include "lib/geometry.glsl"
layout(local_size_x_id = 0) in;

shared uint includedCount;
shared uint nonFinite;
shared uint noArea;
shared uint bits[6];

// Stores the triangle at `index`, zeroed if it is left out; true if it is not.
bool load(uint index) {
    uint number = triangleNumber(index);
    Triangle t = worldTriangle(number);
    bool finite = isFiniteTriangle(t);
    if (finite) t = scaledTriangle(t, -sceneExponent(args.state.at.scene.largest));
    bool included = finite && !liesOnALine(t);
    if (!finite) atomicAdd(nonFinite, 1u);
    else if (!included) atomicAdd(noArea, 1u);
    if (!included) t = Triangle(vec3(0.0), vec3(0.0), vec3(0.0));
    args.triangles.at[index] = treeTriangle(t, number);
    args.sides.at[index] = included ? 1u : 0u;
    return included;
}

void main() {
    uint block = groupIndex();
    if (block >= ceilDiv(args.triangleCount, kBlock)) return;
    uint i = gl_LocalInvocationID.x;
    if (i == 0u) {
        includedCount = 0u;
        nonFinite = 0u;
        noArea = 0u;
    }
    if (i < 6u) bits[i] = 0u;
    meet();
    uint first = block * kBlock;
    uint count = min(kBlock, args.triangleCount - first);
    uint mine = 0u;
    Box b = emptyBox();
    for (uint k = i; k < count; k += gl_WorkGroupSize.x) {
        if (!load(first + k)) continue;
        TreeTriangle t = args.triangles.at[first + k];
        b = including(including(including(b, t.a), t.b), t.c);
        mine++;
    }
    if (mine > 0u) {
        atomicAdd(includedCount, mine);
        for (uint axis = 0u; axis < 3u; axis++) {
            atomicMax(bits[axis], ~orderedBits(b.lo[axis]));
            atomicMax(bits[3u + axis], orderedBits(b.hi[axis]));
        }
    }
    meet();
    if (i < 6u) atomicMax(args.state.at.scene.boundsBits[i], bits[i]);
    if (i != 0u) return;
    atomicAdd(args.state.at.scene.nonFinite, nonFinite);
    atomicAdd(args.state.at.scene.noArea, noArea);
    args.blockSums.at[block] = uvec4(includedCount, 0u, 0u, 0u);
}
