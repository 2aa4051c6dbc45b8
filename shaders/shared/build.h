// The data of a breadth-first build. GLSL and C++ read the same bytes.
//
// A level is a list of nodes and a list of references; the references of a node are consecutive, in the order of
// nodes. Nodes with more than `exactUpTo` references are large: they are cut into chunks and split by binning. The
// others are small: they are split by exact SAH. Those with at most kSubtree are built to their leaves at once.
#ifndef CLEAVE_SHARED_BUILD_H
#define CLEAVE_SHARED_BUILD_H
#include "dispatch.h"
#include "geometry.h"
#include "kd_node.h"
#include "sah.h"
#include "tree_layout.h"

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
    // Where its references go, set by emit_nodes. child: the left child's index in the next level, kNone for a leaf; of
    // a subtree, set by `subtrees`, its root among the staged nodes.
    uint child;
    uint leftBase;   // a left reference goes to leftBase + (left ones of the level before it); leaf: begin of its list
    uint rightBase;  // and a right one to rightBase + (right ones before it)
    Split split;     // axis kLeafAxis: becomes a leaf; kSubtreeAxis: is built already
};
CLEAVE_SIZE(BuildNode, 68);
CLEAVE_CONST uint kSubtreeAxis = 4u;

// What `subtrees` built of a batch of nodes. Their nodes are staged, roots first; children and leaf references count
// from the batch's first.
struct Subtrees {
    uint firstNode;  // of the level
    uint endNode;
    uint roots;
    uint nodes;  // roots included; 0: none was built
    uint leafRefs;
    uint levels;
};
CLEAVE_SIZE(Subtrees, 24);

// A node of a level of subtrees,
struct WorkNode {
    Box cell;
    uint first;  // of its references in the list of the level
    uint count;
    uint staged;  // its number among the staged nodes
};
CLEAVE_SIZE(WorkNode, 36);
// how it is split, a bit per reference,
struct WorkSplit {
    uint axis;
    float position;
    uint left;
    uint right;
    uint both;  // those that are clipped
    uint cut;   // the first of them among all
};
CLEAVE_SIZE(WorkSplit, 24);
// and a reference to be clipped.
struct WorkCut {
    uint ref;
    uint node;
    uint bit;
};
CLEAVE_SIZE(WorkCut, 12);

// Up to kChunk consecutive references of a large node.
struct Chunk {
    uint node;
    uint first;
    uint count;
};
CLEAVE_SIZE(Chunk, 12);

// Kept per chunk, used in the first chunk of a node: bounds of its references, or of its bins that are open, as ordered
// bits (lo xyz, hi xyz).
CLEAVE_CONST uint kBoundsWords = 6u;
// And its counters: for each axis kBins starts, then kBins ends. They are 0 before a level is binned, and after.
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
    uint above;       // of the first one at or above it
    uint left;        // references that begin before the plane: left of it and of either face
    uint rightBelow;  // those right of the face below: they end at or above the plane
    uint right;       // those that end above the plane
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
CLEAVE_FN Split snapped(SahCosts costs, Split s, Box cell, NearestFaces f) {
    Split best = betterOfBothSides(noSplit(), costs, cell, s.axis, s.position, f.left, f.right, f.planar);
    if (f.below != 0u) best = betterOf(best, costs, cell, s.axis, fromOrderedBits(f.below), f.left, f.rightBelow, 1u);
    if (f.above != 0xFFFFFFFFu) {
        best = betterOf(best, costs, cell, s.axis, fromOrderedBits(f.above), f.left, f.right + f.planar, 0u);
    }
    return best;
}

// A leaf of the tree that was left open, and is built further. Its references are those of the leaf, clipped to its
// cell.
struct OpenLeaf {
    Box cell;
    uint treeNode;
    uint first;  // of its entries in the leaf list
    uint count;
    uint depth;
    uint before;  // references of the open nodes before it
    uint chunk;   // its first chunk, if it is large
};
CLEAVE_SIZE(OpenLeaf, 48);

// A bit beside kLeft and kRight: `classify` has clipped the reference, and its boxes are in the list of clipped boxes.
CLEAVE_CONST uint kClipped = 4u;

// What is kept of a classified reference, in a word: these bits, and how many left and right references of its block
// lie before it.
CLEAVE_FN uint sideWord(uint side, uint leftBefore, uint rightBefore) {
    return side | leftBefore << 8 | rightBefore << 16;
}
CLEAVE_FN uint sidesIn(uint word) { return word & 0xFFu; }
CLEAVE_FN uint leftBefore(uint word) { return (word >> 8) & 0xFFu; }
CLEAVE_FN uint rightBefore(uint word) { return word >> 16; }

// Sizes of a level, and the indirect dispatches over them.
struct Level {
    uint refCount;
    uint nodeCount;
    uint chunkCount;
    uint subtreeRefCount;        // of nodes that `subtrees` builds
    DispatchSize perChunk;       // a workgroup per chunk: bin, choose_split, nearest
    DispatchSize perChunkGroup;  // an invocation per chunk: snap
    DispatchSize perRefBlock;    // a workgroup per kBlock references: exact_split, classify, partition
    DispatchSize perWorker;      // a workgroup per batch, or for several of them: subtrees
    DispatchSize perBatch;       // a workgroup per batch: graft
    DispatchSize perNodeBlock;   // a workgroup per kBlock nodes: count_children, emit_nodes
    DispatchSize once;           // one workgroup, none if the level is empty: scan, next_level
};
CLEAVE_SIZE(Level, 100);

// Describes all triangles together, once they are loaded.
struct SceneState {
    uint largest;   // bits of the largest |coordinate| of a finite vertex
    uint included;  // triangles in the tree
    uint nonFinite;
    uint noArea;
    uint boundsBits[6];  // of the triangles in the tree: ~orderedBits(lo) xyz, orderedBits(hi) xyz; larger is wider
};
CLEAVE_SIZE(SceneState, 40);

// Carries a build from level to level. It is zeroed before a build.
struct BuildState {
    uint nodesUsed;     // KdNodes, those of the next level included
    uint leafRefsUsed;  // entries of the leaf list, those of this level included
    uint nodeBase;      // KdNode of the next level's first node
    uint leafBase;      // where this level's entries of the leaf list begin
    uint subtreeNodes;  // where its subtrees' KdNodes begin, but for their roots
    uint subtreeRefs;   // and their entries of the leaf list
    uint batchesTaken;  // by workgroups of `subtrees`, each of which takes one that is not there in the end
    uint levels;        // with nodes
    uint finish;        // 1: this level does not fit when split, so all its nodes become leaves
    uint neededRefs;    // capacities that the build would have needed; 0 where they sufficed
    uint neededLevelNodes;
    uint neededNodes;
    uint neededLeafRefs;
    uint maxDepth;  // of a leaf
    SceneState scene;
    // Of the level: left and right references, nodes and leaf references of subtrees; at first: triangles in the tree.
    uvec4 refTotals;
    Level level[kMaxDepth + 2u];
};
CLEAVE_SIZE(BuildState, 6612);

#ifndef __cplusplus
#include "lib/build_arrays.glsl"
#endif

// The arrays that a build works on: name, element, its array in GLSL, how many. `n` counts the entries of a build
// (BuildCounts in core/build_layout.h). This list is all that layout, binding, byte count, twin and tests know of them.
#define CLEAVE_SCRATCH_ARRAYS(ROW)                                                                                \
    ROW(geometries, GeometryData, GeometryArray, n.geometries)                                                    \
    ROW(refs0, PrimRef, PrimRefArray, n.refs) /* of even and of odd levels */                                     \
    ROW(refs1, PrimRef, PrimRefArray, n.refs)                                                                     \
    ROW(nodes0, BuildNode, BuildNodeArray, n.levelNodes)                                                          \
    ROW(nodes1, BuildNode, BuildNodeArray, n.levelNodes)                                                          \
    ROW(chunks, Chunk, ChunkArray, n.chunks)                                                                      \
    ROW(bounds, uint, UintArray, n.chunks* kBoundsWords)                                                          \
    ROW(bins, uint, UintArray, n.chunks* kBinWords)                                                               \
    ROW(nearest, NearestFaces, NearestFacesArray, n.chunks)                                                       \
    ROW(openBins, uint, UintArray, n.faceChunks* kBinWords) /* as bins: begins and ends in workFaces */           \
    ROW(sides, uint, UintArray, n.refs)                     /* sideWord(); at first: in the tree */               \
    ROW(clipped, Box, BoxArray, 2 * n.refs)                 /* per reference two: left and right part */          \
    ROW(blockSums, uvec4, Uvec4Array, n.refBlocks)          /* as refTotals: per block of references, or batch */ \
    ROW(batchFirsts, uint, UintArray, n.batches)            /* the first node of each */                          \
    ROW(subtrees, Subtrees, SubtreesArray, n.batches)                                                             \
    ROW(stagedNodes, KdNode, KdNodeArray, n.batches* kStagedNodes)                                                \
    ROW(stagedRefs, uint, UintArray, n.batches* kStagedRefs)                                                      \
    ROW(workRefs, PrimRef, PrimRefArray, n.workers* kWorkRefs) /* these mean nothing between passes */            \
    ROW(workCuts, WorkCut, WorkCutArray, n.workers* kWorkCuts)                                                    \
    ROW(workLists, uint, UintArray, n.workers * 2 * kWorkList)                                                    \
    ROW(workNodes, WorkNode, WorkNodeArray, n.workers * 2 * kWorkNodes)                                           \
    ROW(workOrder, uint, UintArray, n.workers * 3 * kWorkNodes)                                                   \
    ROW(workSplits, WorkSplit, WorkSplitArray, n.workers * 2 * kWorkNodes)                                        \
    ROW(workFaces, uvec2, Uvec2Array, n.faces)     /* six per reference: position, kind */                        \
    ROW(nodeSums, uvec4, Uvec4Array, n.nodeBlocks) /* per block of nodes: see nodeCounts() */

// And those that become the tree.
#define CLEAVE_TREE_ARRAYS(ROW)                                  \
    ROW(triangles, TreeTriangle, TreeTriangleArray, n.triangles) \
    ROW(tree, KdNode, KdNodeArray, n.nodes)                      \
    ROW(leafRefs, uint, UintArray, n.leafRefs)

#define CLEAVE_ARRAY_FIELD(name, Element, Array, count) CLEAVE_ADDRESS(Array) name;

// Where everything is and what to build. One of these per build, in device memory.
struct BuildArgs {
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_ARRAY_FIELD)
    CLEAVE_TREE_ARRAYS(CLEAVE_ARRAY_FIELD)
    CLEAVE_ADDRESS(BuildStateRef) state;
    CLEAVE_ADDRESS(Tree) header;
    CLEAVE_ADDRESS(UintArray) list;      // numbers of the tree's triangles, where numberCount is not 0
    CLEAVE_ADDRESS(OpenLeafArray) open;  // of a tree that is expanded: what is built further
    uint triangleCount;                  // of the tree, those that are left out included
    uint numberCount;                    // triangleCount, or 0 where a triangle's number is its index
    uint geometryCount;
    uint refCapacity;        // references of one level: refs0, refs1, ...
    uint levelNodeCapacity;  // nodes of one level
    uint nodeCapacity;       // KdNodes
    uint leafRefCapacity;
    uint binCount;  // bins per axis, 2 to kBins
    uint exactUpTo;
    uint maxDepth;   // 0: by the formula
    uint clip;       // 0: boxes of straddling references are cut, not clipped
    uint subsample;  // 1: large nodes are binned by a part of their references
    uint snap;       // 0: their planes stay between bins
    uint row;        // the most workgroups in a row of a dispatch
    float invBinCount;
    SahCosts costs;
    uint everything;  // 1: bins are counted also where a node is flat
    uint workers;     // the most workgroups of `subtrees`
    uint openCount;   // of `open`; 0: the tree is built from its root
    uint openRefs;    // their references
    uint openDepth;   // the depth of the deepest
    uint reserved;
};
CLEAVE_SIZE(BuildArgs, 360);

#ifndef __cplusplus
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer BuildArgsRef { BuildArgs at; };
#endif

// Says what `scan` sums up.
CLEAVE_CONST uint kScanRefs = 0u;
CLEAVE_CONST uint kScanTriangles = 1u;

struct BuildPush {
    CLEAVE_ADDRESS(BuildArgsRef) args;
    uint depth;  // of the level: even levels are in refs0 and nodes0, odd ones in refs1 and nodes1
    uint scans;  // of the pass `scan`: kScanRefs or kScanTriangles
};
CLEAVE_SIZE(BuildPush, 16);

// The deepest leaf of a tree over n triangles: round(8 + 1.3 log2 n), the field's formula. Logarithms differ between
// devices; these are the numbers of triangles from which on it is one more, that is the least n with n^13 >= 2^(10 k -
// 5).
CLEAVE_FN uint defaultDepth(uint n) {
    uint d = 8u;
    d += uint(n >= 2u) + uint(n >= 3u) + uint(n >= 4u);
    d += uint(n >= 7u) + uint(n >= 12u) + uint(n >= 19u);
    d += uint(n >= 32u) + uint(n >= 55u) + uint(n >= 93u);
    d += uint(n >= 159u) + uint(n >= 271u) + uint(n >= 461u);
    d += uint(n >= 785u) + uint(n >= 1337u) + uint(n >= 2279u);
    d += uint(n >= 3884u) + uint(n >= 6619u) + uint(n >= 11281u);
    d += uint(n >= 19226u) + uint(n >= 32768u) + uint(n >= 55849u);
    d += uint(n >= 95186u) + uint(n >= 162232u) + uint(n >= 276501u);
    d += uint(n >= 471257u) + uint(n >= 803192u) + uint(n >= 1368929u);
    d += uint(n >= 2333148u) + uint(n >= 3976526u) + uint(n >= 6777434u);
    d += uint(n >= 11551193u) + uint(n >= 19687400u) + uint(n >= 33554432u);
    d += uint(n >= 57188859u) + uint(n >= 97470448u) + uint(n >= 166124810u);
    d += uint(n >= 283136613u) + uint(n >= 482566942u) + uint(n >= 822468176u);
    return d;
}
CLEAVE_FN uint depthLimit(uint setting, uint n) { return setting != 0u ? min(setting, kMaxDepth) : defaultDepth(n); }

// The most chunks that a level of `refs` references can have.
CLEAVE_FN uint chunkCapacity(uint refs, uint exactUpTo) { return refs / (exactUpTo + 1u) + refs / kChunk + 1u; }

// The most workgroups of `subtrees`, where a level has at most so many batches.
CLEAVE_FN uint workersFor(uint batches) { return min(ceilDiv(batches, kBatchesPerWorker), kMostWorkers); }

// `row`: the most workgroups in a row of a dispatch.
CLEAVE_FN Level levelOf(uint refCount, uint nodeCount, uint chunkCount, uint subtreeRefCount, uint workers, uint row) {
    Level l;
    l.refCount = refCount;
    l.nodeCount = nodeCount;
    l.chunkCount = chunkCount;
    l.subtreeRefCount = subtreeRefCount;
    l.perChunk = dispatchSize(chunkCount, row);
    l.perChunkGroup = dispatchSize(ceilDiv(chunkCount, kGroup), row);
    l.perRefBlock = dispatchSize(ceilDiv(refCount, kBlock), row);
    l.perWorker = dispatchSize(min(ceilDiv(subtreeRefCount, kBatch), workers), row);
    l.perBatch = dispatchSize(ceilDiv(subtreeRefCount, kBatch), row);
    l.perNodeBlock = dispatchSize(ceilDiv(nodeCount, kBlock), row);
    l.once = dispatchSize(min(nodeCount, 1u), row);
    return l;
}

// The root's cell: the bounds of the triangles in the tree, or a point at the origin without any.
CLEAVE_FN Box rootCell(SceneState s) {
    Box b;
    b.lo = vec3(0.0f);
    b.hi = vec3(0.0f);
    for (uint axis = 0u; axis < 3u && s.included > 0u; axis++) {
        b.lo[axis] = fromOrderedBits(~s.boundsBits[axis]);
        b.hi[axis] = fromOrderedBits(s.boundsBits[3u + axis]);
    }
    return b;
}

CLEAVE_FN bool isLarge(uint count, uint exactUpTo) { return count > exactUpTo; }
// Whether a node is built to its leaves at once.
CLEAVE_FN bool isSubtree(uint count, uint exactUpTo) { return count > 0u && count <= min(exactUpTo, kSubtree); }
CLEAVE_FN uint subtreeRefsOf(uint count, uint exactUpTo) { return isSubtree(count, exactUpTo) ? count : 0u; }
CLEAVE_FN uint chunksOf(uint count, uint exactUpTo) { return isLarge(count, exactUpTo) ? ceilDiv(count, kChunk) : 0u; }

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

// Of a node whose references are [first, first + count) of those that `subtrees` treats: the batch that begins at it or
// at the node after it, kNone if none does.
CLEAVE_FN uint batchAt(uint first, uint count) {
    uint batch = ceilDiv(first, kBatch);
    return batch * kBatch < first + count ? batch : kNone;
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

// Whether references are counted on an axis: where only the ends are candidates, nobody asks for the counts.
CLEAVE_FN bool isBinned(BinRange r, bool everything) { return everything || isResolved(r); }

// The plane between bin b - 1 and bin b, for 1 <= b < count.
CLEAVE_FN float innerPlane(BinRange r, uint b) {
    precise float offset = r.width * float(b);
    return r.lo + offset;
}
// For 0 and `count` the ends of the range.
CLEAVE_FN float binPlane(BinRange r, uint b) {
    if (b == 0u) return r.lo;
    if (b >= r.count) return r.hi;
    return innerPlane(r, b);
}

// How many inner planes lie at or before x (before x, if `strictly`). The guess may be off by one through rounding;
// comparing with the planes themselves puts it right, so that counters agree with sideOf().
// Without branches, which cost CPU devices most of a bin's time.
CLEAVE_FN uint binIndex(BinRange r, float x, bool strictly) {
    uint b = min(uint(max((x - r.lo) * r.invWidth, 0.0f)), r.count - 1u);
    float below = innerPlane(r, b);
    float above = innerPlane(r, b + 1u);
    uint isBefore = uint(b > 0u && (below > x || (strictly && below == x)));
    uint isAfter = uint(b + 1u < r.count && (above < x || (!strictly && above == x)));
    return isResolved(r) ? b + isAfter - isBefore : 0u;
}

// The counters that a reference adds to, on one axis. A flat one counts as left of a plane that it lies in.
CLEAVE_FN uint startBin(BinRange r, float lo, float hi) { return binIndex(r, lo, lo == hi); }
CLEAVE_FN uint endBin(BinRange r, float hi) { return binIndex(r, hi, true); }

CLEAVE_END
#endif
