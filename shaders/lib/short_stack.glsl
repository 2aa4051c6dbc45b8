// Traversal with a short stack (Horn et al. 2007) in registers: the far children that wait, the nearest on top. Those that
// no longer fit are forgotten; the restart trail still knows them, and once the stack is empty the walk descends again
// from the restart node, as the stackless one always does.
#ifndef CLEAVE_LIB_SHORT_STACK
#define CLEAVE_LIB_SHORT_STACK
#include "shared/trail.h"
#include "lib/restart.glsl"

const uint kShortStack = 4u;

// As traverseRestart(), and resumed in the same way, with a trail from either of them.
bool traverseShortStack(TreeParts tree, ScaledRay ray, bool anyHit, uint stepLimit, inout Best best, inout Trail trail,
                        inout StepCount steps) {
    Walk walk;
    Visit start;
    start.node = 0u;
    uint startDepth = 0u;
    if (!enterRoot(tree.bounds, ray, walk, start.tMin, start.tMax)) return true;
    float limit = limitOf(best, walk);
    uint seen = 0u;
    Visit at = start;
    uint depth = 0u;
    uvec4 nodes = uvec4(0u);
    vec4 begins = vec4(0.0);
    vec4 ends = vec4(0.0);
    uint count = 0u;
    float forgotten = infinity();  // a lower bound of t over the cells that fell out of the stack
    while (true) {
        KdNode node = nodeAt(tree, at.node);
        while (!isLeaf(node) && at.tMin <= limit) {
            seen++;
            if (CLEAVE_COUNT_STEPS) steps.inner++;
            PlaneStep s = stepAt(node, walk, at.tMin, at.tMax);
            TrailStep t = trailStepAt(node, s, at, trail, depth);
            trail = t.trail;
            forgotten = t.farWaits && count == kShortStack ? min(forgotten, begins.w) : forgotten;
            nodes = t.farWaits ? uvec4(t.far.node, nodes.xyz) : nodes;
            begins = t.farWaits ? vec4(t.far.tMin, begins.xyz) : begins;
            ends = t.farWaits ? vec4(t.far.tMax, ends.xyz) : ends;
            count = t.farWaits ? min(count + 1u, kShortStack) : count;
            at = t.next;
            depth++;
            bool pushesDown = count == 0u && forgotten == infinity();  // nothing above is left to visit
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
        do {
            if (count == 0u && (forgotten == infinity() || limit < forgotten)) return true;
            uint open = deepestOpen(trail, depth);
            trail = openedAt(trail, open);
            if (count == 0u) {
                if (CLEAVE_COUNT_STEPS) steps.restarts++;
                at = start;
                depth = startDepth;
                forgotten = infinity();
                break;
            }
            at.node = nodes.x;
            at.tMin = begins.x;
            at.tMax = ends.x;
            depth = open + 1u;
            nodes = uvec4(nodes.yzw, 0u);
            begins = vec4(begins.yzw, 0.0);
            ends = vec4(ends.yzw, 0.0);
            count--;
        } while (at.tMin > limit);
        if (seen > stepLimit && staysAsItIs(best, ray.tExponent)) return false;
    }
    return true;
}
#endif
