// Stackless traversal: descends from the restart node to a leaf, then again for what is left, guided by the trail.
//
// Widened intervals overlap, so t cannot prove progress; the trail does. Whether a node has one or two children to
// visit is decided from the ray's own interval, never from the shrunk one, so that each descent decides it alike.
#ifndef CLEAVE_LIB_RESTART
#define CLEAVE_LIB_RESTART
#include "shared/trail.h"
#include "lib/walk.glsl"

// A step at a plane that a trail decides. Walks that resume each other's trails must take it alike.
struct TrailStep {
    Trail trail;    // with a bit set where the ray meets one child only
    bool farWaits;  // the far child is left for later
    Visit next;
    Visit far;
};

TrailStep trailStepAt(KdNode node, PlaneStep s, Visit at, Trail trail, uint depth) {
    bool both = s.goNear && s.goFar;
    bool takeFar = both ? trailBit(trail, depth) : !s.goNear;
    TrailStep t;
    t.trail = both ? trail : withBit(trail, depth);
    t.farWaits = both && !takeFar;
    t.far.node = nodeChild(node) + 1u - s.near;
    t.far.tMin = max(at.tMin, s.tLow);
    t.far.tMax = at.tMax;
    t.next.node = takeFar ? t.far.node : nodeChild(node) + s.near;
    t.next.tMin = takeFar ? t.far.tMin : at.tMin;
    t.next.tMax = takeFar ? at.tMax : min(at.tMax, s.tHigh);
    return t;
}

// Looks for a hit that is closer than `best`; t is in scaled units. Returns false if the ray is given up, which happens
// after a leaf once more inner nodes and triangles than `stepLimit` have been seen, and before a leaf that is open. It
// can then be resumed with the trail and the best hit that are returned, and the answer is that of an uninterrupted
// traversal:
// - A traversal resumes at the root instead of at the restart node. Above the restart node nothing was left to visit,
//   so all bits of the trail are 1 there. The choice between one and two children depends on the ray's own interval
//   only, so the descent takes the same children, with the same intervals, and passes the restart node as it would
//   have started there. (tMin grows along a path: if the best hit ends the descent earlier, it would have ended it
//   at the restart node, and no cell is left to visit either way.)
// - `best` returns with the same bits. Callers keep it in world units, so a ray is not given up while converting there
//   and back would change its t, as it does where the world's t is below the smallest normal number. Few cells are
//   left to visit then, those that begin next to the origin.
bool traverseRestart(TreeParts tree, ScaledRay ray, bool anyHit, uint stepLimit, inout Best best, inout Trail trail,
                     inout StepCount steps) {
    Walk walk;
    Visit start;
    start.node = 0u;
    uint startDepth = 0u;
    if (!enterRoot(tree.bounds, ray, walk, start.tMin, start.tMax)) return true;
    float limit = limitOf(best, walk);
    uint seen = 0u;
    while (true) {
        Visit at = start;
        uint depth = startDepth;
        float pending = infinity();  // a lower bound of t over all cells that are still to be visited
        KdNode node = nodeAt(tree, at.node);
        while (!isLeaf(node) && at.tMin <= limit) {
            seen++;
            if (CLEAVE_COUNT_STEPS) steps.inner++;
            PlaneStep s = stepAt(node, walk, at.tMin, at.tMax);
            TrailStep t = trailStepAt(node, s, at, trail, depth);
            trail = t.trail;
            pending = t.farWaits ? min(pending, s.tLow) : pending;
            at = t.next;
            depth++;
            bool pushesDown = pending == infinity();  // nothing above is left to visit
            start.node = pushesDown ? at.node : start.node;
            start.tMin = pushesDown ? at.tMin : start.tMin;
            start.tMax = pushesDown ? at.tMax : start.tMax;
            startDepth = pushesDown ? depth : startDepth;
            node = nodeAt(tree, at.node);
        }
        if (isLeaf(node) && at.tMin <= limit) {
            if (waitsAt(at.node, best, ray)) return false;
            seen += leafCount(node);
            bool found = testLeaf(tree, ray, node, anyHit, best, steps);
            if (anyHit && found) return true;
            limit = limitOf(best, walk);
        }
        // Ties go to the lower number, so a cell that begins at the best t must still be visited.
        if (pending == infinity() || limit < pending) return true;
        trail = advanced(trail, depth);
        if (CLEAVE_COUNT_STEPS) steps.restarts++;
        if (seen > stepLimit && staysAsItIs(best, ray.tExponent)) return false;
    }
    return true;
}
#endif
