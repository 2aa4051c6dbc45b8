#version 460
// Begins a level with the nodes that a tree was left open at (lazy building, Hunt et al. 2007): they, and the references of
// their leaves. Boxes are made anew, from triangles and cells. A workgroup per block of references.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "lib/build.glsl"
#include "lib/clip.glsl"
layout(local_size_x_id = 0) in;

void beginLevel() {
    TreeData t = args.header.at;
    OpenLeaf last = args.open.at[args.openCount - 1u];
    args.state.at.nodesUsed = t.nodeCount;
    args.state.at.leafRefsUsed = t.leafRefCount;
    args.state.at.maxDepth = depthLimit(args.maxDepth, t.triangleCount - t.nonFinite - t.noArea) - args.openDepth;
    uint chunks = last.chunk + chunksOf(last.count, args.exactUpTo);
    args.state.at.level[0] = levelOf(args.openRefs, args.openCount, chunks, 0u, args.workers, args.row);
}

void beginNode(uint index, OpenLeaf open) {
    args.nodes0.at[index] = buildNode(open.cell, open.before, open.count, open.treeNode, open.chunk);
    uint chunks = chunksOf(open.count, args.exactUpTo);
    for (uint c = 0u; c < chunks; c++) args.chunks.at[open.chunk + c] = chunkOf(index, open.before, open.count, c);
    if (chunks > 0u) setBounds(open.chunk, open.cell);
}

// The node of a reference: the last that has none after it.
uint openNodeOf(uint ref) {
    uint low = 0u;
    uint high = args.openCount;
    while (high - low > 1u) {
        uint middle = (low + high) >> 1;
        if (args.open.at[middle].before <= ref) low = middle;
        else high = middle;
    }
    return low;
}

// The box of what of a triangle is in a cell. It lies there, so that a box without a point is one that rounding has lost.
Box partIn(Triangle t, Box cell) {
    Box box = intersection(triangleBox(t), cell);
    if (args.clip == 0u) return box;
    Box part = partsOf(t, box, 0u, box.hi.x).left;
    return isEmpty(part) ? box : part;
}

void main() {
    uint block = groupIndex();
    if (block >= ceilDiv(args.openRefs, kBlock)) return;
    uint first = block * kBlock;
    uint end = min(first + kBlock, args.openRefs);
    for (uint k = first + gl_LocalInvocationID.x; k < end; k += gl_WorkGroupSize.x) {
        uint index = openNodeOf(k);
        OpenLeaf open = args.open.at[index];
        if (k == 0u) beginLevel();
        if (k == open.before) beginNode(index, open);
        PrimRef r;
        r.prim = args.leafRefs.at[open.first + k - open.before];
        Box box = partIn(withoutNumber(args.triangles.at[r.prim]), open.cell);
        r.lo = box.lo;
        r.hi = box.hi;
        r.node = index;
        args.refs0.at[k] = r;
    }
}
