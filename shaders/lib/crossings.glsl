// All crossings of a ray, by the rule "once" of crossing.h, in the order of (t, number). A walk collects the first few
// behind a given one; who wants more walks again from the last of them. So a triangle that several leaves list is found
// once, whatever their number, without memory for those that were found before.
#ifndef CLEAVE_LIB_CROSSINGS
#define CLEAVE_LIB_CROSSINGS
#include "lib/stack.glsl"

// What of the ray is behind the mark, or at its t.
ScaledRay restOf(ScaledRay ray, Mark after) {
    ray.tMin = max(ray.tMin, timesPowerOfTwo(max(after.t, 0.0), -ray.tExponent));
    return ray;
}

// The first `capacity` crossings behind the mark, at most kCrossings, but for the one that waits: where it counts, it
// takes the place of the last. `ray` is restOf() the mark.
CrossingList collect(TreeParts tree, ScaledRay ray, Mark after, uint capacity) {
    CrossingList list = emptyCrossings(capacity, after, ray);
    Best best = bestOf(missedHit(), ray);
    StepCount steps = noSteps();
    walkStack(tree, ray, kAllCrossings, best, list, steps);
    return list;
}

// The next crossing behind the mark, or a miss.
Hit crossingBehind(Tree tree, Ray ray, Mark after) {
    Hit next = missedHit();
    if (!isValidRay(ray)) return next;
    TreeParts parts = partsOf(tree);
    ScaledRay rest = restOf(scaledRay(ray, tree.at.exponent), after);
    CrossingList list = collect(parts, rest, after, 1u);
    for (uint k = kLastCrossing; k <= kCrossings; k++) {
        uint index = crossingAt(list, k);
        if (index == kNone) continue;
        Decided d = decideCrossing(parts, rest, after, index);
        if (d.counts && isCloser(d.hit, next)) next = d.hit;
    }
    return next;
}

// How often a valid ray crosses the tree's triangles; or, `signed`, how often more it leaves than enters.
int crossings(Tree tree, Ray ray, bool isSigned) {
    TreeParts parts = partsOf(tree);
    ScaledRay scaled = scaledRay(ray, tree.at.exponent);
    int total = 0;
    Mark after = beforeAll();
    while (true) {
        ScaledRay rest = restOf(scaled, after);
        CrossingList list = collect(parts, rest, after, kCrossings);
        bool goesOn = isFull(list);
        bool decidesAll = isSigned || goesOn;
        for (uint k = 0u; k < kCrossings && !decidesAll; k++) total += list.index[k] != kNone ? 1 : 0;
        Mark last = beforeAll();
        for (uint k = decidesAll ? 0u : kCrossings; k <= kCrossings; k++) {
            uint index = crossingAt(list, k);
            if (index == kNone) continue;
            Decided d = decideCrossing(parts, rest, after, index);
            // The one that waited counts next time if it is behind the others.
            if (!d.counts || (k == kCrossings && goesOn && isBehind(d.hit, last))) continue;
            total += isSigned ? d.side : 1;
            if (isBehind(d.hit, last)) last = markAt(d.hit);
        }
        if (!goesOn) return total;
        after = last;
    }
    return total;
}
#endif
