#version 460
// A number into every field of the shared structs, counting up.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_buffer_reference_uvec2 : require
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
    r.buildNode.child = 52u;
    r.buildNode.leftBase = 53u;
    r.buildNode.rightBase = 54u;
    r.buildNode.split.cost = 55.0;
    r.buildNode.split.planarLeft = 56u;
    r.chunk.node = 57u;
    r.chunk.first = 58u;
    r.chunk.count = 59u;
    r.steps.inner = 60u;
    r.steps.leaves = 61u;
    r.steps.triangles = 62u;
    r.steps.restarts = 63u;
    r.steps.hitLeaf = 64u;
    r.counters.invalidRays = 65u;
    r.counters.unfinishedRays = 66u;
    r.state.nodesUsed = 67u;
    r.state.leafRefsUsed = 68u;
    r.state.nodeBase = 69u;
    r.state.leafBase = 70u;
    r.state.levels = 71u;
    r.state.finish = 72u;
    r.state.neededRefs = 73u;
    r.state.neededLevelNodes = 74u;
    r.state.neededNodes = 75u;
    r.state.neededLeafRefs = 76u;
    r.state.refTotals = uvec4(77u, 78u, 79u, 80u);
    r.state.level[0].refCount = 85u;
    r.state.level[0].nodeCount = 86u;
    r.state.level[0].chunkCount = 87u;
    r.state.level[1].refCount = 89u;
    r.state.level[1].nodeCount = 90u;
    r.state.level[1].chunkCount = 91u;
    r.state.level[kMaxDepth + 1].refCount = 93u;
    r.state.level[kMaxDepth + 1].nodeCount = 94u;
    r.state.level[kMaxDepth + 1].chunkCount = 95u;
    r.state.level[1].perChunk.x = 97u;
    r.state.level[1].perChunk.y = 98u;
    r.state.level[1].perChunk.z = 99u;
    r.state.level[1].perChunkGroup.x = 100u;
    r.state.level[1].perChunkGroup.y = 101u;
    r.state.level[1].perChunkGroup.z = 102u;
    r.state.level[1].perRefBlock.x = 106u;
    r.state.level[1].perRefBlock.y = 107u;
    r.state.level[1].perRefBlock.z = 108u;
    r.state.level[1].perBatch.x = 109u;
    r.state.level[1].perBatch.y = 110u;
    r.state.level[1].perBatch.z = 111u;
    r.state.level[1].perNodeBlock.x = 112u;
    r.state.level[1].perNodeBlock.y = 113u;
    r.state.level[1].perNodeBlock.z = 114u;
    r.state.level[1].once.x = 115u;
    r.state.level[1].once.y = 116u;
    r.state.level[1].once.z = 117u;
    uint next = kFirstListed;
#define SET_UINT(field) r.field = next++;
#define SET_INT(field) r.field = int(next++);
#define SET_FLOAT(field) r.field = float(next++);
#define SET_DOUBLE(field) r.field = double(next++);
#define SET_ADDRESS(field, Array) r.field = Array(uvec2(next++, 0u));
    CLEAVE_LAYOUT_FIELDS(SET_UINT, SET_INT, SET_FLOAT, SET_DOUBLE, SET_ADDRESS)
#define SET_BUILD(name, Element, Array, count) r.buildArgs.name = Array(uvec2(next++, 0u));
#define SET_PICTURE(name, Element, Array, count) r.pictureArgs.name = Array(uvec2(next++, 0u));
    CLEAVE_LAYOUT_ARRAYS(SET_BUILD, SET_PICTURE)
}
