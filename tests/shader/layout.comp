#version 460
// A number into every field of the shared structs, counting up.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "layout.h"

layout(local_size_x = 1) in;
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer RecordRef { LayoutRecord at; };
layout(push_constant, scalar) uniform Push { RecordRef record; };

#define r record.at

void main() {
    r.box.lo = vec3(1.0, 2.0, 3.0);
    r.box.hi = vec3(4.0, 5.0, 6.0);
    r.node.plane = 7u;
    r.node.link = 8u;
    r.split.cost = 9.0;
    r.split.axis = 10u;
    r.split.position = 11.0;
    r.split.planarLeft = 12u;
    r.ray.origin = vec3(13.0, 14.0, 15.0);
    r.ray.tMin = 16.0;
    r.ray.direction = vec3(17.0, 18.0, 19.0);
    r.ray.tMax = 20.0;
    r.hit.t = 21.0;
    r.hit.prim = 22u;
    r.hit.u = 23.0;
    r.hit.v = 24.0;
    r.triangle.a = vec3(25.0, 26.0, 27.0);
    r.triangle.b = vec3(28.0, 29.0, 30.0);
    r.triangle.c = vec3(31.0, 32.0, 33.0);
    r.ref.lo = vec3(34.0, 35.0, 36.0);
    r.ref.prim = 37u;
    r.ref.hi = vec3(38.0, 39.0, 40.0);
    r.ref.node = 41u;
    r.buildNode.cell.lo = vec3(42.0, 43.0, 44.0);
    r.buildNode.cell.hi = vec3(45.0, 46.0, 47.0);
    r.buildNode.first = 48u;
    r.buildNode.count = 49u;
    r.buildNode.treeNode = 50u;
    r.buildNode.chunk = 51u;
    r.buildNode.split.cost = 52.0;
    r.buildNode.split.planarLeft = 53u;
    r.chunk.node = 54u;
    r.chunk.first = 55u;
    r.chunk.count = 56u;
    r.steps.inner = 57u;
    r.steps.leaves = 58u;
    r.steps.triangles = 59u;
    r.steps.restarts = 60u;
    r.steps.hitLeaf = 61u;
    r.counters.invalidRays = 62u;
    r.counters.cappedRays = 63u;
    r.state.nodesUsed = 64u;
    r.state.leafRefsUsed = 65u;
    r.state.nodeBase = 66u;
    r.state.leafBase = 67u;
    r.state.levels = 68u;
    r.state.finish = 69u;
    r.state.neededRefs = 70u;
    r.state.neededLevelNodes = 71u;
    r.state.neededNodes = 72u;
    r.state.neededLeafRefs = 73u;
    r.state.refTotals = uvec4(74u, 75u, 76u, 77u);
    r.state.nodeTotals = uvec4(78u, 79u, 80u, 81u);
    r.state.level[0].refCount = 82u;
    r.state.level[0].nodeCount = 83u;
    r.state.level[0].chunkCount = 84u;
    r.state.level[0].smallCount = 85u;
    r.state.level[1].refCount = 86u;
    r.state.level[1].nodeCount = 87u;
    r.state.level[1].chunkCount = 88u;
    r.state.level[1].smallCount = 89u;
    r.state.level[kMaxDepth + 1].refCount = 90u;
    r.state.level[kMaxDepth + 1].nodeCount = 91u;
    r.state.level[kMaxDepth + 1].chunkCount = 92u;
    r.state.level[kMaxDepth + 1].smallCount = 93u;
    r.state.level[1].perChunk.x = 94u;
    r.state.level[1].perChunk.y = 95u;
    r.state.level[1].perChunk.z = 96u;
    r.state.level[1].perChunkGroup.x = 97u;
    r.state.level[1].perChunkGroup.y = 98u;
    r.state.level[1].perChunkGroup.z = 99u;
    r.state.level[1].perSmall.x = 100u;
    r.state.level[1].perSmall.y = 101u;
    r.state.level[1].perSmall.z = 102u;
    r.state.level[1].perRefBlock.x = 103u;
    r.state.level[1].perRefBlock.y = 104u;
    r.state.level[1].perRefBlock.z = 105u;
    r.state.level[1].perRefGroup.x = 106u;
    r.state.level[1].perRefGroup.y = 107u;
    r.state.level[1].perRefGroup.z = 108u;
    r.state.level[1].perNodeBlock.x = 109u;
    r.state.level[1].perNodeBlock.y = 110u;
    r.state.level[1].perNodeBlock.z = 111u;
    r.state.level[1].once.x = 112u;
    r.state.level[1].once.y = 113u;
    r.state.level[1].once.z = 114u;
}
