// The textbook traversal, to compare with: far children wait on a stack.
#include "lib/walk.glsl"

// The answer for a valid ray, t in scaled units. `capped` is never set: no node is visited twice.
Hit traverse(ScaledRay ray, inout StepCount steps, out bool capped) {
    capped = false;
    Hit best = missedHit();
    vec3 inverse = vec3(1.0) / ray.direction;  // not used where the direction is 0
    Visit waiting[kMaxDepth];                  // at most one per inner node on the way down
    uint count = 0u;
    Visit at;
    at.node = 0u;
    if (!enterRoot(ray, inverse, push.bounds, at.tMin, at.tMax)) return best;
    while (true) {
        KdNode node = push.nodes.at[at.node];
        while (!isLeaf(node) && at.tMin <= best.t) {
            if (kCountSteps) steps.inner++;
            PlaneStep s = stepAt(node, ray, inverse, at.tMin, at.tMax);
            if (s.goNear && s.goFar) {
                waiting[count].node = nodeChild(node) + 1u - s.near;
                waiting[count].tMin = max(at.tMin, s.tLow);
                waiting[count].tMax = at.tMax;
                count++;
            }
            at.node = nodeChild(node) + (s.goNear ? s.near : 1u - s.near);
            if (s.goNear) at.tMax = min(at.tMax, s.tHigh);
            else at.tMin = max(at.tMin, s.tLow);
            node = push.nodes.at[at.node];
        }
        if (isLeaf(node) && at.tMin <= best.t) {
            bool found = testLeaf(ray, node, best, steps);
            if (kAnyHit && found) return best;
        }
        // A tie goes to the lower number, so a cell that begins at the best t must still be seen.
        while (count > 0u && waiting[count - 1u].tMin > best.t) count--;
        if (count == 0u) return best;
        at = waiting[--count];
    }
    return best;
}
