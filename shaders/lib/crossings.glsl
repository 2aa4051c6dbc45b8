// All crossings of a ray, by the rule "once" of crossing.h, in the order of (t, number). A walk collects the first few
// behind a given one; who wants more walks again from the last of them. So a triangle that several leaves list is found
// once, whatever their number, without memory for those that were found before.
#ifndef CLEAVE_LIB_CROSSINGS
#define CLEAVE_LIB_CROSSINGS
#include "shared/crossing.h"
#include "lib/leaf_walk.glsl"

const uint kCrossings = 8u;
const uint kLastCrossing = kCrossings - 1u;

// Where to go on from: t is that of the world.
struct Mark {
    float t;
    uint number;
};

Mark beforeAll() {
    Mark m;
    m.t = -infinity();
    m.number = 0u;
    return m;
}

// Ascending; t is that of the world, since two that differ when scaled may be equal there. Slots that may not be used
// come first, those that are empty last.
struct CrossingList {
    float t[kCrossings];
    uint index[kCrossings];  // of the triangle in the tree
};

CrossingList emptyCrossings(uint capacity) {
    CrossingList list;
    for (uint k = 0u; k < kCrossings; k++) {
        list.t[k] = k + capacity < kCrossings ? -infinity() : infinity();
        list.index[k] = kNone;
    }
    return list;
}

bool holds(CrossingList list, uint index) {
    bool found = false;
    for (uint k = 0u; k < kCrossings; k++) found = found || list.index[k] == index;
    return found;
}

// Sorts it in; what was last falls out.
void insert(inout CrossingList list, float t, uint index) {
    for (uint k = 0u; k < kCrossings; k++) {
        bool swaps = t < list.t[k] || (t == list.t[k] && index < list.index[k]);
        float nextT = swaps ? list.t[k] : t;
        uint nextIndex = swaps ? list.index[k] : index;
        list.t[k] = swaps ? t : list.t[k];
        list.index[k] = swaps ? index : list.index[k];
        t = nextT;
        index = nextIndex;
    }
}

Crossing crossingOf(ScaledRay ray, TreeTriangle t) {
    return crossTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
}

// The scaled t up to which crossings can still enter the list. World t below the smallest normal number are 0.
float scaledEnd(CrossingList list, ScaledRay ray) {
    float last = max(list.t[kLastCrossing], kSmallestNormal);
    return min(ray.tMax, timesPowerOfTwo(last, -ray.tExponent));
}

void collectFrom(TreeParts tree, ScaledRay ray, KdNode leaf, Mark after, inout CrossingList list) {
    uint first = leafFirst(leaf);
    uint end = first + leafCount(leaf);
    float scaledEndNow = scaledEnd(list, ray);
    for (uint i = first; i < end; i++) {
        uint index = tree.leafRefs.at[i];
        TreeTriangle triangle = triangleAt(tree, index);
        FilteredHit f = filterTriangle(ray.origin, ray.direction, triangle.a, triangle.b, triangle.c);
        if (f.misses || f.tLow > scaledEndNow || f.tHigh < ray.tMin || holds(list, index)) continue;
        Crossing c = crossingOf(ray, triangle);
        if (c.side == 0 || c.t < ray.tMin || c.t > ray.tMax) continue;
        float t = timesPowerOfTwo(c.t, ray.tExponent);
        if (t < after.t || (t == after.t && triangle.number <= after.number)) continue;
        insert(list, t, index);
        scaledEndNow = scaledEnd(list, ray);
    }
}

// The first `capacity` crossings behind the mark, at most kCrossings.
CrossingList collect(TreeParts tree, ScaledRay ray, Mark after, uint capacity) {
    CrossingList list = emptyCrossings(capacity);
    ScaledRay rest = ray;
    rest.tMin = max(ray.tMin, timesPowerOfTwo(max(after.t, 0.0), -ray.tExponent));
    Walk walk;
    float tMin;
    float tMax;
    if (!enterRoot(tree.bounds, rest, walk, tMin, tMax)) return list;
    LeafWalk leaves = leafWalk(tMin, tMax);
    KdNode leaf;
    while (true) {
        float end = scaledEnd(list, ray);
        float limit = end + abs(end) * kWiden - walk.start;
        limit += abs(limit) * kWiden;
        if (!nextLeaf(tree, walk, limit, leaves, leaf)) return list;
        collectFrom(tree, ray, leaf, after, list);
    }
    return list;
}

uint countOf(CrossingList list) {
    uint count = 0u;
    for (uint k = 0u; k < kCrossings; k++) count += list.index[k] != kNone ? 1u : 0u;
    return count;
}

Mark markOf(TreeParts tree, float t, uint index) {
    Mark m;
    m.t = t;
    m.number = triangleAt(tree, index).number;
    return m;
}

Hit crossingHit(TreeParts tree, ScaledRay ray, float t, uint index) {
    TreeTriangle triangle = triangleAt(tree, index);
    Crossing c = crossingOf(ray, triangle);
    Hit h;
    h.t = t;
    h.prim = triangle.number;
    h.u = c.u;
    h.v = c.v;
    return h;
}

// The next crossing behind the mark, or a miss.
Hit crossingBehind(Tree tree, Ray ray, Mark after) {
    if (!isValidRay(ray)) return missedHit();
    TreeParts parts = partsOf(tree);
    ScaledRay scaled = scaledRay(ray, tree.at.exponent);
    CrossingList list = collect(parts, scaled, after, 1u);
    if (list.index[kLastCrossing] == kNone) return missedHit();
    return crossingHit(parts, scaled, list.t[kLastCrossing], list.index[kLastCrossing]);
}

// How often a valid ray crosses the tree's triangles; or, `signed`, how often more it leaves than enters.
int crossings(Tree tree, Ray ray, bool isSigned) {
    TreeParts parts = partsOf(tree);
    ScaledRay scaled = scaledRay(ray, tree.at.exponent);
    int total = 0;
    Mark after = beforeAll();
    while (true) {
        CrossingList list = collect(parts, scaled, after, kCrossings);
        uint count = countOf(list);
        if (!isSigned) total += int(count);
        for (uint k = 0u; k < count && isSigned; k++) total += crossingOf(scaled, triangleAt(parts, list.index[k])).side;
        if (count < kCrossings) return total;
        after = markOf(parts, list.t[kLastCrossing], list.index[kLastCrossing]);
    }
    return total;
}
#endif
