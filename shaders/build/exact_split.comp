#version 460
// Exact SAH of the small nodes that `subtrees` left: every face of every box is a candidate. A workgroup treats the nodes whose references
// begin in its block of references: first the best face of each box is found, then of these the best in each node. So
// nodes of a few references, which most are, share a workgroup.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "lib/build.glsl"
layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint kRefsPerLane = 1u;  // consecutive ones, which share loads and mostly a node

// The best face of each box: its cost, and which one it is. The last node may begin with the block's last reference.
const uint kMostRefs = kBlock + kMostExactUpTo;
shared float costs[kMostRefs];
shared uint faces[kMostRefs];  // 4 axis + 2 if it is the upper one + planarLeft

bool isSplitHere(BuildNode node) { return !isLarge(node.count, args.exactUpTo) && node.split.axis != kSubtreeAxis; }

Split splitAt(PrimRef r, float cost, uint face) {
    Split s;
    s.cost = cost;
    s.axis = face >> 2;
    s.position = (face & 2u) != 0u ? r.hi[s.axis] : r.lo[s.axis];
    s.planarLeft = face & 1u;
    return s;
}

// References on either side of the faces of a box, and in them, on each axis.
struct FaceCounts {
    PrimRef r;
    uint first, end;  // references of its node; none if that is not split here
    uvec3 loLeft, loRight, loPlanar;
    uvec3 hiLeft, hiRight, hiPlanar;
};

FaceCounts faceCounts(uint k, uint end) {
    FaceCounts f;
    f.r = refsIn().at[min(k, end - 1u)];
    BuildNode node = nodesIn().at[f.r.node];
    bool counts = k < end && isSplitHere(node);
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

FaceCounts with(FaceCounts f, PrimRef o, bool isInNode) {
    uvec3 one = uvec3(isInNode ? 1u : 0u);
    f.loLeft += one * uvec3(lessThan(o.lo, f.r.lo));
    f.loRight += one * uvec3(greaterThan(o.hi, f.r.lo));
    f.hiLeft += one * uvec3(lessThan(o.lo, f.r.hi));
    f.hiRight += one * uvec3(greaterThan(o.hi, f.r.hi));
    return f;
}

FaceCounts withFlat(FaceCounts f, PrimRef o, bool isInNode) {
    uvec3 isFlat = isInNode ? uvec3(equal(o.lo, o.hi)) : uvec3(0u);
    f.loPlanar += isFlat * uvec3(equal(o.lo, f.r.lo));
    f.hiPlanar += isFlat * uvec3(equal(o.lo, f.r.hi));
    return f;
}

// The cost of a plane; infinite if it is not strictly inside the cell.
float costAt(Box cell, uint axis, float position, uint left, uint right) {
    bool isInside = cell.lo[axis] < position && position < cell.hi[axis];
    float cost = splitCost(args.costs, cell, axis, position, left, right);
    return isInside ? cost : infinity();
}

// Sets costs and faces at `slot`. Candidates come in the order of isBetter(), so that the first of the cheapest is best.
void chooseFace(FaceCounts f, bool anyFlat, uint slot) {
    Box cell = nodesIn().at[f.r.node].cell;
    float best = infinity();
    uint face = 0u;
    [[unroll]] for (uint side = 0u; side < 6u; side++) {
        uint axis = side >> 1;
        bool upper = (side & 1u) != 0u;
        float position = upper ? f.r.hi[axis] : f.r.lo[axis];
        uint left = upper ? f.hiLeft[axis] : f.loLeft[axis];
        uint right = upper ? f.hiRight[axis] : f.loRight[axis];
        uint planar = upper ? f.hiPlanar[axis] : f.loPlanar[axis];
        float cost = costAt(cell, axis, position, left + planar, right);
        if (cost < best) {
            best = cost;
            face = 2u * side + 1u;
        }
        if (!anyFlat) continue;
        cost = costAt(cell, axis, position, left, right + planar);
        if (planar > 0u && cost < best) {
            best = cost;
            face = 2u * side;
        }
    }
    costs[slot] = best;
    faces[slot] = face;
}

// For kRefsPerLane references from k on, but none from `end` on. `begin` has slot 0.
void findBestFaces(uint k, uint end, uint begin) {
    PrimRefArray refs = refsIn();
    FaceCounts f[kRefsPerLane];
    uint from = end;
    uint to = 0u;
    [[unroll]] for (uint i = 0u; i < kRefsPerLane; i++) {
        f[i] = faceCounts(k + i, end);
        if (f[i].end == 0u) continue;
        from = min(from, f[i].first);
        to = max(to, f[i].end);
    }
    bool anyFlat = false;
    for (uint j = from; j < to; j++) {
        PrimRef o = refs.at[j];
        [[unroll]] for (uint i = 0u; i < kRefsPerLane; i++) f[i] = with(f[i], o, j >= f[i].first && j < f[i].end);
        anyFlat = anyFlat || any(equal(o.lo, o.hi));
    }
    for (uint j = from; anyFlat && j < to; j++) {  // rare
        PrimRef o = refs.at[j];
        [[unroll]] for (uint i = 0u; i < kRefsPerLane; i++) f[i] = withFlat(f[i], o, j >= f[i].first && j < f[i].end);
    }
    [[unroll]] for (uint i = 0u; i < kRefsPerLane; i++) {
        if (f[i].end != 0u) chooseFace(f[i], anyFlat, k + i - begin);
    }
}

void main() {
    uint block = groupIndex();
    uint refCount = thisLevel.refCount;
    if (block >= ceilDiv(refCount, kBlock) || push.depth >= args.state.at.maxDepth) return;
    PrimRefArray refs = refsIn();
    BuildNodeArray nodes = nodesIn();
    uint begin = block * kBlock;
    uint end = min(begin + kBlock, refCount);
    BuildNode node = nodes.at[refs.at[begin].node];
    if (node.first < begin) begin = node.first + node.count;
    if (begin >= end) return;
    uint firstNode = refs.at[begin].node;
    uint lastNode = refs.at[end - 1u].node;
    node = nodes.at[lastNode];
    end = isSplitHere(node) ? node.first + node.count : node.first;
    uint stride = gl_WorkGroupSize.x * kRefsPerLane;
    for (uint k = begin + gl_LocalInvocationID.x * kRefsPerLane; k < end; k += stride) findBestFaces(k, end, begin);
    meet();
    for (uint n = firstNode + gl_LocalInvocationID.x; n <= lastNode; n += gl_WorkGroupSize.x) {
        node = nodes.at[n];
        if (!isSplitHere(node)) continue;
        Split best = noSplit();
        for (uint k = node.first; k < node.first + node.count; k++) {
            float cost = costs[k - begin];
            if (cost > best.cost || cost == infinity()) continue;
            Split s = splitAt(refs.at[k], cost, faces[k - begin]);
            if (isBetter(s, best)) best = s;
        }
        if (isWorthwhile(args.costs, best, node.cell, node.count, push.depth, args.state.at.maxDepth)) nodes.at[n].split = best;
    }
}
