// The first few crossings of a ray, while a walk finds them: by the rule "once" of crossing.h, in the order of
// (t, number).
//
// What float arithmetic is sure of goes into the list with an interval that holds its t; double arithmetic decides once
// the walk is over. What cannot be placed that way waits until then, or until a second triangle would have to: nearly
// always all of a group's lanes then decide together.
#ifndef CLEAVE_LIB_CROSSING_LIST
#define CLEAVE_LIB_CROSSING_LIST
#include "shared/crossing.h"
#include "lib/walk.glsl"

const uint kCrossings = 8u;
const uint kLastCrossing = kCrossings - 1u;

// A place in the order of crossings, to go on from: t is that of the world.
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

Mark markAt(Hit hit) {
    Mark m;
    m.t = hit.t;
    m.number = hit.prim;
    return m;
}

bool isBehind(Hit hit, Mark mark) { return hit.t > mark.t || (hit.t == mark.t && hit.prim > mark.number); }

// In scaled units, ascending by `high`. Slots that may not be used come first, those that are empty last. An interval
// that is a point was decided; otherwise t lies between its ends and is neither of them.
struct CrossingList {
    float low[kCrossings];
    float high[kCrossings];
    uint index[kCrossings];  // of the triangle in the tree
    uint waiting;            // the index of one that may belong into the list; kNone: none
    Mark after;              // only what is behind is sought
    float sureFrom;          // and whose scaled t is above this certainly is
    float least;             // scaled t below this are 0 in the world
};

CrossingList emptyCrossings(uint capacity, Mark after, ScaledRay ray) {
    CrossingList list;
    for (uint k = 0u; k < kCrossings; k++) {
        list.high[k] = k + capacity < kCrossings ? -infinity() : infinity();
        list.low[k] = list.high[k];
        list.index[k] = kNone;
    }
    list.waiting = kNone;
    list.after = after;
    list.least = timesPowerOfTwo(kSmallestNormal, -ray.tExponent);
    list.sureFrom = after.t < 0.0 ? -1.0 : max(list.least, timesPowerOfTwo(after.t, -ray.tExponent));
    return list;
}

bool isFull(CrossingList list) { return list.index[kLastCrossing] != kNone; }

// The slots' indices, then the one that waits. Selects, since a variable index would put the arrays into memory.
uint crossingAt(CrossingList list, uint k) {
    uint index = list.waiting;
    for (uint n = 0u; n < kCrossings; n++) index = n == k ? list.index[n] : index;
    return index;
}

bool holds(CrossingList list, uint index) {
    bool found = list.waiting == index;
    for (uint k = 0u; k < kCrossings; k++) found = found || list.index[k] == index;
    return found;
}

// Sorts it in; what was last falls out.
void insert(inout CrossingList list, float low, float high, uint index) {
    for (uint k = 0u; k < kCrossings; k++) {
        bool swaps = high < list.high[k] || (high == list.high[k] && index < list.index[k]);
        float nextLow = swaps ? list.low[k] : low;
        float nextHigh = swaps ? list.high[k] : high;
        uint nextIndex = swaps ? list.index[k] : index;
        list.low[k] = swaps ? low : list.low[k];
        list.high[k] = swaps ? high : list.high[k];
        list.index[k] = swaps ? index : list.index[k];
        low = nextLow;
        high = nextHigh;
        index = nextIndex;
    }
}

// Whether there is room, or the last is certainly behind all others and the new one.
bool fits(CrossingList list, float high, uint index) {
    float low = list.low[kLastCrossing];
    bool isPoint = low == list.high[kLastCrossing];
    bool isBefore = high < low || (isPoint && high == low && index < list.index[kLastCrossing]);
    return !isFull(list) || (isBefore && list.high[kLastCrossing - 1u] <= low);
}

// The scaled t up to which crossings can still enter the list.
float endOf(CrossingList list, ScaledRay ray) { return isFull(list) ? list.high[kLastCrossing] : ray.tMax; }

struct Decided {
    Hit hit;      // in the world; meaningful if it counts
    int side;     // as of Crossing
    bool counts;  // it is a crossing of the ray behind the mark
    float t;      // scaled
};

// The ray begins at the mark or behind it.
Decided decideCrossing(TreeParts tree, ScaledRay ray, Mark after, uint index) {
    TreeTriangle triangle = triangleAt(tree, index);
    Crossing c = crossTriangle(ray.origin, ray.direction, triangle.a, triangle.b, triangle.c);
    Decided d;
    d.hit.t = timesPowerOfTwo(c.t, ray.tExponent);
    d.hit.prim = triangle.number;
    d.hit.u = c.u;
    d.hit.v = c.v;
    d.side = c.side;
    d.t = c.t;
    d.counts = c.side != 0 && c.t >= ray.tMin && c.t <= ray.tMax && isBehind(d.hit, after);
    return d;
}

// Decides the one that waits, and the last of the list as often as that is needed to see which of them are first.
void settle(TreeParts tree, ScaledRay ray, inout CrossingList list) {
    uint index = list.waiting;
    list.waiting = kNone;
    bool isKnown = false;
    float t = 0.0;
    while (true) {
        uint which = isKnown ? list.index[kLastCrossing] : index;
        Decided d = decideCrossing(tree, ray, list.after, which);
        float exact = d.t < list.least ? 0.0 : d.t;
        if (!isKnown && !d.counts) return;
        if (isKnown) {
            list.high[kLastCrossing] = infinity();
            list.index[kLastCrossing] = kNone;
            insert(list, exact, exact, which);
        } else {
            t = exact;
            isKnown = true;
        }
        if (fits(list, t, index)) {
            insert(list, t, t, index);
            return;
        }
        if (list.low[kLastCrossing] == list.high[kLastCrossing] || t >= list.high[kLastCrossing]) return;
    }
}

void collectFrom(TreeParts tree, ScaledRay ray, KdNode leaf, inout CrossingList list) {
    uint first = leafFirst(leaf);
    uint end = first + leafCount(leaf);
    for (uint i = first; i < end; i++) {
        uint index = tree.leafRefs.at[i];
        TreeTriangle t = triangleAt(tree, index);
        FilteredHit f = filterTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
        if (f.misses || f.tLow > endOf(list, ray) || f.tHigh < ray.tMin || holds(list, index)) continue;
        bool isSure = f.hits && f.tLow >= ray.tMin && f.tLow > list.sureFrom && f.tHigh <= ray.tMax;
        if (isSure && fits(list, f.tHigh, index)) {
            insert(list, f.tLow, f.tHigh, index);
            continue;
        }
        if (list.waiting != kNone) settle(tree, ray, list);
        list.waiting = index;
    }
}
#endif
