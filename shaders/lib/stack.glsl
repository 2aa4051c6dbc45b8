// Traversal with a stack: far children wait on it, the nearest on top.
//
// The four on top are in registers, since some devices (lavapipe) store to an array lane by lane; the others are in an
// array. What happens at a plane is chosen by selection, not by branches, which lanes would take each at its own time.
#ifndef CLEAVE_LIB_STACK
#define CLEAVE_LIB_STACK
#include "shared/config.h"
#include "lib/crossing_list.glsl"
#include "lib/walk.glsl"

// Whether a walk may look for all crossings; kernels that never do are compiled sooner without.
#ifndef CLEAVE_CROSSINGS
#define CLEAVE_CROSSINGS true
#endif

// Marks an entry whose plane is passed at an uncertain t; see walkStack().
const uint kUncertain = 0x80000000u;
const uint kOnTop = 4u;

// Where the part of the ray behind a plane begins, if the part before it ends at t: twice the widening of stepAt(), and
// some, is taken back.
float takenBack(float t) { return t - abs(t) * 4.0 * kWiden; }

// What a walk looks for.
const uint kClosestHit = 0u;
const uint kAnyHit = 1u;
const uint kAllCrossings = 2u;

// Looks for a hit that is closer than `best`, or collects crossings in `list`; t is in scaled units. There is no step
// limit: no node is visited twice, so the work is bounded by the size of the tree. Returns false at a leaf that is open:
// the walk is then to be done anew, with the best hit that is returned.
//
// An entry is a far child and the end of the ray's part in it. The beginning is that of the cell that comes after the
// one visited last, and follows from where that ended. Not so where the ray comes from far away or lies in the plane,
// and the plane is passed somewhere in a wide interval: the entry is marked, and its part begins with the whole ray's.
bool walkStack(TreeParts tree, ScaledRay ray, uint sought, inout Best best, inout CrossingList list,
               inout StepCount steps) {
    Walk walk;
    float begin;
    Visit at;
    at.node = 0u;
    if (!enterRoot(tree.bounds, ray, walk, begin, at.tMax)) return true;
    at.tMin = begin;
    float limit = limitOf(best, walk);
    uvec4 children = uvec4(0u);
    vec4 ends = vec4(0.0);
    double below[kMaxDepth - kOnTop];  // an entry each; a path has at most one per inner node
    uint count = 0u;
    while (true) {
        KdNode node = nodeAt(tree, at.node);
        while (!isLeaf(node)) {
            if (CLEAVE_COUNT_STEPS) steps.inner++;
            PlaneStep s = stepAt(node, walk, at.tMin, min(at.tMax, limit));
            bool both = s.goNear && s.goFar;
            if (both && count >= kOnTop)
                below[count - kOnTop] = packDouble2x32(uvec2(children.w, floatBitsToUint(ends.w)));
            uint far = nodeChild(node) + 1u - s.near;
            far = s.tLow < takenBack(s.tHigh) ? far | kUncertain : far;
            children = both ? uvec4(far, children.xyz) : children;
            ends = both ? vec4(at.tMax, ends.xyz) : ends;
            count = both ? count + 1u : count;
            at.node = nodeChild(node) + (s.goNear ? s.near : 1u - s.near);
            at.tMin = s.goNear ? at.tMin : max(at.tMin, s.tLow);
            at.tMax = s.goNear ? min(at.tMax, s.tHigh) : at.tMax;
            node = nodeAt(tree, at.node);
        }
        if (CLEAVE_CROSSINGS && sought == kAllCrossings) {
            collectFrom(tree, ray, node, list);
            best.tHigh = endOf(list, ray);
        } else {
            if (waitsAt(at.node, best, ray)) return false;
            bool found = testLeaf(tree, ray, node, sought == kAnyHit, best, steps);
            if (sought == kAnyHit && found) return true;
        }
        limit = limitOf(best, walk);
        // Ties go to the lower number, so a cell that begins at the best t must still be visited.
        do {
            if (count == 0u) return true;
            count--;
            at.node = children.x & ~kUncertain;
            at.tMin = (children.x & kUncertain) != 0u ? begin : max(begin, takenBack(at.tMax));
            at.tMax = ends.x;
            children = uvec4(children.yzw, 0u);
            ends = vec4(ends.yzw, 0.0);
            if (count >= kOnTop) {
                uvec2 words = unpackDouble2x32(below[count - kOnTop]);
                children.w = words.x;
                ends.w = uintBitsToFloat(words.y);
            }
        } while (at.tMin > limit);
    }
    return true;
}

bool traverseStack(TreeParts tree, ScaledRay ray, bool anyHit, inout Best best, inout StepCount steps) {
    CrossingList none = emptyCrossings(0u, beforeAll(), ray);
    return walkStack(tree, ray, anyHit ? kAnyHit : kClosestHit, best, none, steps);
}
#endif
