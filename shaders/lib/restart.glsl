// Stackless traversal: descends from the restart node to a leaf, then again for what is left, guided by the trail.
//
// Widened intervals overlap, so t cannot prove progress; the trail does. Whether a node has one or two children to
// visit is decided from the ray's own interval, never from the shrunk one, so that each descent decides it alike.
#ifndef CLEAVE_LIB_RESTART
#define CLEAVE_LIB_RESTART
#include "shared/trail.h"
#include "lib/walk.glsl"

// Looks for a hit that is closer than `best`; t is in scaled units. Returns false if the ray is given up, which happens
// after a leaf once more inner nodes and triangles than `stepLimit` have been seen. It can then be resumed with the
// trail and the best hit that are returned, and the answer is that of an uninterrupted traversal:
// - A traversal resumes at the root instead of at the restart node. Above the restart node nothing was left to visit,
//   so all bits of the trail are 1 there. The choice between one and two children depends on the ray's own interval
//   only, so the descent takes the same children, with the same intervals, and passes the restart node as it would
//   have started there. (tMin grows along a path: if the best hit ends the descent earlier, it would have ended it
//   at the restart node, and no cell is left to visit either way.)
// - `best` returns with the same bits. Callers keep it in world units, so a ray is not given up while converting there
//   and back would change its t, as it does where the world's t is below the smallest normal number. Few cells are
//   left to visit then, those that begin next to the origin.
bool traverseRestart(TreeParts tree, ScaledRay ray, bool anyHit, uint stepLimit, inout Hit best, inout Trail trail,
                     inout StepCount steps) {
    vec3 inverse = vec3(1.0) / ray.direction;  // not used where the direction is 0
    Visit start;
    start.node = 0u;
    uint startDepth = 0u;
    if (!enterRoot(ray, inverse, tree.bounds, start.tMin, start.tMax)) return true;
    uint seen = 0u;
    while (true) {
        Visit at = start;
        uint depth = startDepth;
        float pending = infinity();  // a lower bound of t over all cells that are still to be visited
        KdNode node = tree.nodes.at[at.node];
        while (!isLeaf(node) && at.tMin <= best.t) {
            seen++;
            if (CLEAVE_COUNT_STEPS) steps.inner++;
            PlaneStep s = stepAt(node, ray, inverse, at.tMin, at.tMax);
            bool takeFar = !s.goNear;
            if (s.goNear && s.goFar) takeFar = trailBit(trail, depth);
            else trail = withBit(trail, depth);
            if (takeFar) {
                at.tMin = max(at.tMin, s.tLow);
            } else {
                at.tMax = min(at.tMax, s.tHigh);
                if (s.goFar) pending = min(pending, s.tLow);
            }
            at.node = nodeChild(node) + (takeFar ? 1u - s.near : s.near);
            depth++;
            if (pending == infinity()) {  // push-down: nothing above is left to visit
                start = at;
                startDepth = depth;
            }
            node = tree.nodes.at[at.node];
        }
        if (isLeaf(node) && at.tMin <= best.t) {
            seen += leafCount(node);
            bool found = testLeaf(tree, ray, node, anyHit, best, steps);
            if (anyHit && found) return true;
        }
        // Ties go to the lower number, so a cell that begins at the best t must still be visited.
        if (pending == infinity() || best.t < pending) return true;
        trail = advanced(trail, depth);
        if (CLEAVE_COUNT_STEPS) steps.restarts++;
        if (seen > stepLimit && scaledHit(worldHit(best, ray.tExponent), ray.tExponent).t == best.t) return false;
    }
    return true;
}
#endif
