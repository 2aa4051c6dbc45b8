#version 460
// Exact SAH of the small nodes that `subtrees` left: every face of every box is a candidate. A workgroup treats the nodes
// whose references begin in its block of references: first the best face of each box is found (on CPU devices: of eight
// boxes), then of these the best in each node. So nodes of a few references share a workgroup.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;

// The best face of each box, or of eight boxes: its cost, and which one it is. The last node may begin with the block's
// last reference.
const uint kMostRefs = kBlock + kMostExactUpTo;
shared float faceCosts[kMostRefs];
shared float positions[kMostRefs];
shared uint faces[kMostRefs];  // 2 axis + planarLeft

bool isSplitHere(BuildNode node) { return !isLarge(node.count, args.exactUpTo) && node.split.axis != kSubtreeAxis; }

SahCosts costs;
PrimRefArray refs;
BuildNodeArray nodes;

uint refOf(BuildNode node, uint i) { return node.first + min(i, node.count - 1u); }
#define NODE BuildNode
#define BOXES refs
#include "lib/best_face.glsl"

void put(uint slot, Split s) {
    faceCosts[slot] = s.cost;
    positions[slot] = s.position;
    faces[slot] = 2u * s.axis + s.planarLeft;
}
Split splitAt(uint slot) {
    Split s;
    s.cost = faceCosts[slot];
    s.axis = faces[slot] >> 1;
    s.position = positions[slot];
    s.planarLeft = faces[slot] & 1u;
    return s;
}

// References on either side of the faces of a box, and in them, on each axis.
struct FaceCounts {
    PrimRef r;
    uint first, end;  // references of its node; none if that is not split here
    uvec3 loLeft, loRight, loPlanar;
    uvec3 hiLeft, hiRight, hiPlanar;
};

FaceCounts faceCounts(uint k) {
    FaceCounts f;
    f.r = refs.at[k];
    BuildNode node = nodes.at[f.r.node];
    bool counts = isSplitHere(node);
    f.first = counts ? node.first : 0u;
    f.end = counts ? node.first + node.count : 0u;
    f.loLeft = uvec3(0u);
    f.loRight = uvec3(0u);
    f.loPlanar = uvec3(0u);
    f.hiLeft = uvec3(0u);
    f.hiRight = uvec3(0u);
    f.hiPlanar = uvec3(0u);
    return f;
}

FaceCounts with(FaceCounts f, PrimRef o) {
    f.loLeft += uvec3(lessThan(o.lo, f.r.lo));
    f.loRight += uvec3(greaterThan(o.hi, f.r.lo));
    f.hiLeft += uvec3(lessThan(o.lo, f.r.hi));
    f.hiRight += uvec3(greaterThan(o.hi, f.r.hi));
    return f;
}

FaceCounts withFlat(FaceCounts f, PrimRef o) {
    uvec3 isFlat = uvec3(equal(o.lo, o.hi));
    f.loPlanar += isFlat * uvec3(equal(o.lo, f.r.lo));
    f.hiPlanar += isFlat * uvec3(equal(o.lo, f.r.hi));
    return f;
}

Split cheaperOf(Split best, Box cell, uint axis, float position, uint left, uint right, uint planarLeft, bool counts) {
    float cost = splitCost(costs, cell, axis, position, left, right);
    bool isInside = cell.lo[axis] < position && position < cell.hi[axis];
    if (counts && isInside && cost < best.cost) {
        best.cost = cost;
        best.axis = axis;
        best.position = position;
        best.planarLeft = planarLeft;
    }
    return best;
}

// Faces come in the order of isBetter(), so that the first of the cheapest is best.
Split bestFaceOf(FaceCounts f, bool anyFlat) {
    Box cell = nodes.at[f.r.node].cell;
    Split best = noSplit();
    [[unroll]] for (uint side = 0u; side < 6u; side++) {
        uint axis = side >> 1;
        bool upper = (side & 1u) != 0u;
        float position = upper ? f.r.hi[axis] : f.r.lo[axis];
        uint left = upper ? f.hiLeft[axis] : f.loLeft[axis];
        uint right = upper ? f.hiRight[axis] : f.loRight[axis];
        uint planar = upper ? f.hiPlanar[axis] : f.loPlanar[axis];
        best = cheaperOf(best, cell, axis, position, left + planar, right, 1u, true);
        if (anyFlat) best = cheaperOf(best, cell, axis, position, left, right + planar, 0u, planar > 0u);
    }
    return best;
}

// For reference k. `begin` has slot 0.
void findBestFace(uint k, uint begin) {
    FaceCounts f = faceCounts(k);
    bool anyFlat = false;
    for (uint j = f.first; j < f.end; j++) {
        PrimRef o = refs.at[j];
        f = with(f, o);
        anyFlat = anyFlat || any(equal(o.lo, o.hi));
    }
    for (uint j = f.first; anyFlat && j < f.end; j++) f = withFlat(f, refs.at[j]);  // rare
    if (f.end != 0u) put(k - begin, bestFaceOf(f, anyFlat));
}

// For CPU devices: an invocation takes eight references of a node, which has a slot for each eight from its first's on.
void findBestOfRuns(uint node, uint last, uint begin) {
    uint run = gl_LocalInvocationID.x;
    bool isFound;
    do {
        do {
            uint runs = isSplitHere(nodes.at[node]) ? ceilDiv(nodes.at[node].count, 8u) : 0u;
            isFound = run < runs;
            if (!isFound) {
                run -= runs;
                node++;
            }
        } while (!isFound && node <= last);
        if (isFound) put(nodes.at[node].first - begin + run, bestOfRun(nodes.at[node], 8u * run));
        run += gl_WorkGroupSize.x;
    } while (isFound);
}

void main() {
    uint block = groupIndex();
    uint refCount = thisLevel.refCount;
    if (block >= ceilDiv(refCount, kBlock) || push.depth >= args.state.at.maxDepth) return;
    costs = args.costs;
    refs = refsIn();
    nodes = nodesIn();
    uint begin = block * kBlock;
    uint end = min(begin + kBlock, refCount);
    BuildNode node = nodes.at[refs.at[begin].node];
    if (node.first < begin) begin = node.first + node.count;
    if (begin >= end) return;
    uint firstNode = refs.at[begin].node;
    uint lastNode = refs.at[end - 1u].node;
    node = nodes.at[lastNode];
    end = isSplitHere(node) ? node.first + node.count : node.first;
    if (kLockstep) {
        findBestOfRuns(firstNode, lastNode, begin);
    } else {
        for (uint k = begin + gl_LocalInvocationID.x; k < end; k += gl_WorkGroupSize.x) findBestFace(k, begin);
    }
    meet();
    uint perSlot = kLockstep ? 8u : 1u;
    for (uint n = firstNode + gl_LocalInvocationID.x; n <= lastNode; n += gl_WorkGroupSize.x) {
        node = nodes.at[n];
        if (!isSplitHere(node)) continue;
        Split best = noSplit();
        for (uint k = 0u; k < ceilDiv(node.count, perSlot); k++) {
            Split s = splitAt(node.first - begin + k);
            if (isBetter(s, best)) best = s;
        }
        if (isWorthwhile(costs, best, node.cell, node.count, push.depth, args.state.at.maxDepth)) nodes.at[n].split = best;
    }
}
