// Stack-less traversal: descend from the restart node to a leaf, then again for what is left, guided by the trail.
//
// Widened intervals overlap, so t cannot prove progress; the trail does. Whether a node has one or two children to visit
// is decided from the ray's own interval, never from the shrunk one, so that it comes out alike on each descent.
#include "shared/trail.h"
#include "lib/walk.glsl"

// The answer for a valid ray, t in scaled units; `capped` where the ray was given up.
Hit traverse(ScaledRay ray, inout StepCount steps, out bool capped) {
    capped = false;
    Hit best = missedHit();
    vec3 inverse = vec3(1.0) / ray.direction;  // not used where the direction is 0
    Visit start;
    start.node = 0u;
    uint startDepth = 0u;
    if (!enterRoot(ray, inverse, push.bounds, start.tMin, start.tMax)) return best;
    Trail trail = emptyTrail();
    uint visited = 0u;
    while (true) {
        Visit at = start;
        uint depth = startDepth;
        float pending = infinity();  // no point of a cell that is still to be visited has a smaller t
        KdNode node = push.nodes.at[at.node];
        while (!isLeaf(node) && at.tMin <= best.t) {
            visited++;
            if (kCountSteps) steps.inner++;
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
            node = push.nodes.at[at.node];
        }
        if (isLeaf(node) && at.tMin <= best.t) {
            bool found = testLeaf(ray, node, best, steps);
            if (kAnyHit && found) return best;
        }
        // A tie goes to the lower number, so a cell that begins at the best t must still be seen.
        if (pending == infinity() || best.t < pending) return best;
        if (visited > kStepCap) {
            capped = true;
            return missedHit();
        }
        trail = advanced(trail, depth);
        if (kCountSteps) steps.restarts++;
    }
    return best;
}
