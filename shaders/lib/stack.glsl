// The textbook traversal, to compare with: far children wait on a stack.
#ifndef CLEAVE_LIB_STACK
#define CLEAVE_LIB_STACK
#include "shared/config.h"
#include "lib/walk.glsl"

// Looks for a hit that is closer than `best`; t is in scaled units. There is no step limit: no node is visited twice,
// so the work is bounded by the size of the tree.
void traverseStack(TreeParts tree, ScaledRay ray, bool anyHit, inout Hit best, inout StepCount steps) {
    vec3 inverse = vec3(1.0) / ray.direction;  // not used where the direction is 0
    Visit waiting[kMaxDepth];                  // at most one per inner node of a path
    uint count = 0u;
    Visit at;
    at.node = 0u;
    if (!enterRoot(ray, inverse, tree.bounds, at.tMin, at.tMax)) return;
    while (true) {
        KdNode node = tree.nodes.at[at.node];
        while (!isLeaf(node) && at.tMin <= best.t) {
            if (CLEAVE_COUNT_STEPS) steps.inner++;
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
            node = tree.nodes.at[at.node];
        }
        if (isLeaf(node) && at.tMin <= best.t) {
            bool found = testLeaf(tree, ray, node, anyHit, best, steps);
            if (anyHit && found) return;
        }
        // Ties go to the lower number, so a cell that begins at the best t must still be visited.
        while (count > 0u && waiting[count - 1u].tMin > best.t) count--;
        if (count == 0u) return;
        at = waiting[--count];
    }
}
#endif
