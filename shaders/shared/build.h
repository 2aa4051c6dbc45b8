// The data of a breadth-first build, as every pass of it sees them. GLSL and C++ read the same bytes.
//
// A level is a list of nodes and a list of references; the references of a node are consecutive, in the order of
// nodes. Nodes with more than `exactBelow` references are large: they are cut into chunks and split by binning. The
// others are small: they are split by exact SAH.
#ifndef CLEAVE_SHARED_BUILD_H
#define CLEAVE_SHARED_BUILD_H
#include "dispatch.h"
#include "kd_node.h"
#include "sah.h"
#include "triangle.h"

CLEAVE_BEGIN

// A reference: the part of a triangle that lies in a node's cell, by its box.
struct PrimRef {
    vec3 lo;
    uint prim;
    vec3 hi;
    uint node;  // index into the level's nodes
};
CLEAVE_SIZE(PrimRef, 32);

// A node of the level under construction.
struct BuildNode {
    Box cell;
    uint first;  // of its references
    uint count;
    uint treeNode;  // index of its KdNode
    uint chunk;     // its first chunk, if it is large
    // Where its references go, set by emit_nodes. child: the left child's index in the next level, kNone for a leaf.
    uint child;
    uint leftBase;   // a left reference goes to leftBase + (left ones of the level before it); leaf: begin of its list
    uint rightBase;  // and a right one to rightBase + (right ones before it)
    Split split;     // axis kLeafAxis: becomes a leaf
};
CLEAVE_SIZE(BuildNode, 68);

// Up to kChunk consecutive references of a large node.
struct Chunk {
    uint node;
    uint first;
    uint count;
};
CLEAVE_SIZE(Chunk, 12);

// Kept per chunk, used in the first chunk of a node: bounds of its references as ordered bits (lo xyz, hi xyz).
CLEAVE_CONST uint kBoundsWords = 6u;
// And its counters: for each axis kBins starts, then kBins ends.
CLEAVE_CONST uint kBinWords = 6u * kBins;

// With subsampling a node's bins count every l-th of its references only, l = max(1, floor(log10 n)) (Shevtsov et al.
// 2007, section 4.1). A table: logarithms differ between devices.
CLEAVE_FN uint sampleStep(uint n, bool subsample) {
    uint step = 1u;
    uint next = 100u;  // the least number with a larger logarithm
    while (subsample && step < 9u && n >= next) {
        step++;
        if (step < 9u) next *= 10u;
    }
    return step;
}

// Estimates a count on one side of a bin boundary from a sampled one. Never 0: that a side is empty, which costs less,
// is known of the ends of the bins only.
CLEAVE_FN uint estimatedCount(uint sampled, uint step, uint n) {
    return step == 1u ? sampled : min(max(sampled * step, 1u), n);
}

// Between two faces of boxes the counts on either side of a plane are constant and the cost is affine (survey, section
// 4), so moving a boundary of bins to the nearest face on one side or the other never costs more, unless that face is
// the cell's own. Kept per chunk, used in the first chunk of a node: the faces next to the node's split, and the counts
// for a plane there.
struct NearestFaces {
    uint below;       // ordered bits of the last face before the plane; 0 if there is none
    uint above;       // of the first one at or behind it
    uint left;        // references that begin before the plane: left of it and of either face
    uint rightBelow;  // those right of the face below: they end at or behind the plane
    uint right;       // those that end behind the plane
    uint planar;      // those that lie in it
};
CLEAVE_SIZE(NearestFaces, 24);

CLEAVE_FN NearestFaces noFaces() {
    NearestFaces f;
    f.below = 0u;
    f.above = 0xFFFFFFFFu;
    f.left = 0u;
    f.rightBelow = 0u;
    f.right = 0u;
    f.planar = 0u;
    return f;
}

// With one more reference.
CLEAVE_FN NearestFaces including(NearestFaces f, float lo, float hi, float plane) {
    if (lo < plane)
        f.below = max(f.below, orderedBits(lo));
    else
        f.above = min(f.above, orderedBits(lo));
    if (hi < plane)
        f.below = max(f.below, orderedBits(hi));
    else
        f.above = min(f.above, orderedBits(hi));
    f.left += lo < plane ? 1u : 0u;
    f.rightBelow += hi >= plane ? 1u : 0u;
    f.right += hi > plane ? 1u : 0u;
    f.planar += lo == plane && hi == plane ? 1u : 0u;
    return f;
}

// The best of a split and of those at the faces next to it. The counts at the split are true, those of bins may be
// estimates. References that begin at the face below, or end at the one above, count on both sides of it here though
// they will go to one: its cost is an upper bound.
CLEAVE_FN Split snapped(Split s, Box cell, NearestFaces f) {
    Split best = betterOfBothSides(noSplit(), cell, s.axis, s.position, f.left, f.right, f.planar);
    if (f.below != 0u) best = betterOf(best, cell, s.axis, fromOrderedBits(f.below), f.left, f.rightBelow, 1u);
    if (f.above != 0xFFFFFFFFu) {
        best = betterOf(best, cell, s.axis, fromOrderedBits(f.above), f.left, f.right + f.planar, 0u);
    }
    return best;
}

// What `classify` decided about a reference, beside kLeft and kRight: its boxes are in the list of clipped boxes.
CLEAVE_CONST uint kClipped = 4u;

// Sizes of a level, and the indirect dispatches over them.
struct Level {
    uint refCount;
    uint nodeCount;
    uint chunkCount;
    uint smallCount;
    DispatchSize perChunk;       // a workgroup per chunk: bounds, bin, nearest
    DispatchSize perChunkGroup;  // an invocation per chunk: choose_split, snap
    DispatchSize perSmall;       // a workgroup per small node: exact_split
    DispatchSize perRefBlock;    // a workgroup per kBlock references: classify, offsets
    DispatchSize perRefGroup;    // an invocation per reference: partition
    DispatchSize perNodeBlock;   // a workgroup per kBlock nodes: count_children, emit_nodes
    DispatchSize once;           // one workgroup, none if the level is empty: scan, next_level
};
CLEAVE_SIZE(Level, 100);

// What survives from level to level, and what the host reads back. Zeroed before a build.
struct BuildState {
    uint nodesUsed;     // KdNodes, those of the next level included
    uint leafRefsUsed;  // entries of the leaf list, those of this level included
    uint nodeBase;      // KdNode of the next level's first node
    uint leafBase;      // where this level's entries of the leaf list begin
    uint levels;        // with nodes
    uint finish;        // 1: this level does not fit when split, so all its nodes become leaves
    uint neededRefs;    // capacities that the build would have needed; 0 where they sufficed
    uint neededLevelNodes;
    uint neededNodes;
    uint neededLeafRefs;
    uvec4 refTotals;   // of the level: left, right references
    uvec4 nodeTotals;  // of the level: splits, references in leaves, chunks, small nodes
    Level level[kMaxDepth + 2u];
};
CLEAVE_SIZE(BuildState, 6572);

#ifndef __cplusplus
#include "lib/build_arrays.glsl"
#endif

// Where everything is. One of these per build, in device memory.
struct BuildArgs {
    CLEAVE_ADDRESS(TriangleArray) triangles;
    CLEAVE_ADDRESS(UintArray) included;
    CLEAVE_ADDRESS(PrimRefArray) refs0;  // of even and of odd levels
    CLEAVE_ADDRESS(PrimRefArray) refs1;
    CLEAVE_ADDRESS(BuildNodeArray) nodes0;
    CLEAVE_ADDRESS(BuildNodeArray) nodes1;
    CLEAVE_ADDRESS(ChunkArray) chunks;
    CLEAVE_ADDRESS(UintArray) bounds;           // kBoundsWords per chunk
    CLEAVE_ADDRESS(UintArray) bins;             // kBinWords per chunk
    CLEAVE_ADDRESS(NearestFacesArray) nearest;  // one per chunk
    CLEAVE_ADDRESS(UintArray) smallNodes;       // indices of the level's small nodes
    CLEAVE_ADDRESS(UintArray) sides;            // per reference: kLeft | kRight | kClipped
    CLEAVE_ADDRESS(BoxArray) clipped;           // per reference two: left and right part
    CLEAVE_ADDRESS(Uvec2Array) offsets;         // per reference and one more: left and right references before it
    CLEAVE_ADDRESS(Uvec4Array) blockSums;       // per block of references: left, right
    CLEAVE_ADDRESS(Uvec4Array) nodeSums;        // per block of nodes: as BuildState.nodeTotals
    CLEAVE_ADDRESS(KdNodeArray) tree;
    CLEAVE_ADDRESS(UintArray) leafRefs;
    CLEAVE_ADDRESS(BuildStateRef) state;
    Box root;
    uint includedCount;
    uint refCapacity;        // references of one level: refs0, refs1, ...
    uint levelNodeCapacity;  // nodes of one level
    uint nodeCapacity;       // KdNodes
    uint leafRefCapacity;
    uint binCount;  // bins per axis, 2 to kBins
    uint exactBelow;
    uint maxDepth;
    uint clip;       // 0: boxes of straddling references are cut, not clipped
    uint subsample;  // 1: large nodes are binned by a part of their references
    float invBinCount;
};
CLEAVE_SIZE(BuildArgs, 224);

#ifndef __cplusplus
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer BuildArgsRef { BuildArgs at; };
#endif

struct BuildPush {
    CLEAVE_ADDRESS(BuildArgsRef) args;
    uint depth;      // of the level: even levels are in refs0 and nodes0, odd ones in refs1 and nodes1
    uint scanNodes;  // scan: 1 for the sums of nodes, 0 for those of references
};

// The most chunks that a level of `refs` references can have.
CLEAVE_FN uint chunkCapacity(uint refs, uint exactBelow) { return refs / (exactBelow + 1u) + refs / kChunk + 1u; }

CLEAVE_FN Level levelOf(uint refCount, uint nodeCount, uint chunkCount, uint smallCount) {
    Level l;
    l.refCount = refCount;
    l.nodeCount = nodeCount;
    l.chunkCount = chunkCount;
    l.smallCount = smallCount;
    l.perChunk = dispatchSize(chunkCount);
    l.perChunkGroup = dispatchSize(ceilDiv(chunkCount, kGroup));
    l.perSmall = dispatchSize(smallCount);
    l.perRefBlock = dispatchSize(ceilDiv(refCount, kBlock));
    l.perRefGroup = dispatchSize(ceilDiv(refCount, kGroup));
    l.perNodeBlock = dispatchSize(ceilDiv(nodeCount, kBlock));
    l.once = dispatchSize(min(nodeCount, 1u));
    return l;
}

CLEAVE_FN bool isLarge(uint count, uint exactBelow) { return count > exactBelow; }
CLEAVE_FN uint chunksOf(uint count, uint exactBelow) {
    return isLarge(count, exactBelow) ? ceilDiv(count, kChunk) : 0u;
}
CLEAVE_FN uint smallsOf(uint count, uint exactBelow) { return count > 0u && !isLarge(count, exactBelow) ? 1u : 0u; }

CLEAVE_FN BuildNode buildNode(Box cell, uint first, uint count, uint treeNode, uint chunk) {
    BuildNode n;
    n.cell = cell;
    n.first = first;
    n.count = count;
    n.treeNode = treeNode;
    n.chunk = chunk;
    n.child = kNone;
    n.leftBase = 0u;
    n.rightBase = 0u;
    n.split = noSplit();
    return n;
}

// Chunk number `index` of a node.
CLEAVE_FN Chunk chunkOf(uint node, uint first, uint count, uint index) {
    Chunk c;
    c.node = node;
    c.first = first + index * kChunk;
    c.count = min(kChunk, count - index * kChunk);
    return c;
}

// The bins of one axis of a node: they span the bounds of its references.
struct BinRange {
    float lo;
    float hi;
    float width;
    float invWidth;  // for a first guess only: division differs between devices
    uint count;
};

CLEAVE_FN BinRange binRange(float lo, float hi, uint count, float invCount) {
    BinRange r;
    r.lo = lo;
    r.hi = hi;
    precise float width = (hi - lo) * invCount;
    r.width = width;
    r.invWidth = 1.0f / max(width, kSmallestNormal);
    r.count = count;
    return r;
}

// Whether the range is wide enough for floats to tell its planes apart. If not, only its ends are candidates.
CLEAVE_FN bool isResolved(BinRange r) {
    return r.width >= kSmallestNormal && r.lo + r.width > r.lo && r.hi - r.width < r.hi;
}

// The plane between bin b - 1 and bin b, for 1 <= b < count; for 0 and `count` the ends of the range.
CLEAVE_FN float binPlane(BinRange r, uint b) {
    if (b == 0u) return r.lo;
    if (b >= r.count) return r.hi;
    precise float offset = r.width * float(b);
    return r.lo + offset;
}

// How many inner planes lie at or before x (before x, if `strictly`). The guess may be off by one through rounding;
// comparing with the planes themselves puts it right, so that counters agree with sideOf().
CLEAVE_FN uint binIndex(BinRange r, float x, bool strictly) {
    if (!isResolved(r)) return 0u;
    uint b = min(uint(max((x - r.lo) * r.invWidth, 0.0f)), r.count - 1u);
    float below = binPlane(r, b);
    float above = binPlane(r, b + 1u);
    if (b > 0u && (strictly ? below >= x : below > x)) return b - 1u;
    if (b + 1u < r.count && (strictly ? above < x : above <= x)) return b + 1u;
    return b;
}

// The counters that a reference adds to, on one axis. A flat one counts as left of a plane that it lies in.
CLEAVE_FN uint startBin(BinRange r, float lo, float hi) { return binIndex(r, lo, lo == hi); }
CLEAVE_FN uint endBin(BinRange r, float hi) { return binIndex(r, hi, true); }

CLEAVE_END
#endif
