#version 460
// Writes what a tree begins with: counts, bounds, where its parts are, and the capacities that it would have needed.
// One invocation.
#extension GL_GOOGLE_include_directive : require
#include "lib/build.glsl"
layout(local_size_x = 1) in;

#define state args.state.at

void main() {
    bool isShort = (state.neededRefs | state.neededLevelNodes | state.neededNodes | state.neededLeafRefs) != 0u;
    bool expands = args.openCount > 0u;
    TreeData t;
    if (expands) t = args.header.at;
    t.magic = kTreeMagic;
    t.format = kTreeFormatNumber;
    t.status = isShort ? kShortOfCapacity : 0u;
    t.levels = expands ? max(t.levels, args.openDepth + state.levels) : state.levels;
    t.triangleCount = args.triangleCount;
    t.nodeCount = state.nodesUsed;
    t.leafRefCount = state.leafRefsUsed;
    if (!expands) {
        t.nonFinite = state.scene.nonFinite;
        t.noArea = state.scene.noArea;
        t.exponent = sceneExponent(state.scene.largest);
        t.bounds = rootCell(state.scene);
    }
    t.wantedRefs = state.neededRefs;
    t.wantedLevelNodes = state.neededLevelNodes;
    t.wantedNodes = state.neededNodes;
    t.wantedLeafRefs = state.neededLeafRefs;
    t.bytes = treeBytes(args.triangleCount, state.nodesUsed, state.leafRefsUsed);
    t.wantedBytes = treeBytes(args.triangleCount, max(args.nodeCapacity, state.neededNodes),
                              max(args.leafRefCapacity, state.neededLeafRefs));
    if (!isShort) t.wantedBytes = uvec2(0u);
    t.triangles = args.triangles;
    t.reserved = uvec2(0u);
    t.nodes = args.tree;
    t.leafRefs = args.leafRefs;
    args.header.at = t;
}
