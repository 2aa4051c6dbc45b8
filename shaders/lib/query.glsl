// Queries in world space: what shaders call.
#ifndef CLEAVE_LIB_QUERY
#define CLEAVE_LIB_QUERY
#include "shared/ray.h"
#include "shared/traversal.h"
#include "lib/restart.glsl"
#include "lib/short_stack.glsl"
#include "lib/stack.glsl"
#include "lib/crossings.glsl"

// kRestartTraversal, kShortStackTraversal or kStackTraversal. Answers are the same.
#ifndef CLEAVE_TRAVERSAL
#define CLEAVE_TRAVERSAL kRestartTraversal
#endif

// Inner nodes and triangle tests after which trace() and occluded() give up and answer with a miss. Far more than rays
// of valid trees need.
#ifndef CLEAVE_STEP_LIMIT
#define CLEAVE_STEP_LIMIT (1u << 30)
#endif

// Goes on from `hit`, which stays unless the tree has a closer one, and from `trail`, which is empty at first. For
// any-hit queries a given hit is the answer. The ray must be valid. Returns false if the ray is given up at the limit,
// or waits; called again with what it left in `hit` and `trail`, it goes on as if it had not been interrupted. The t of `hit` is in
// units of 2^unit.
bool search(Tree tree, Ray ray, int unit, bool anyHit, uint stepLimit, inout Hit hit, inout Trail trail,
            inout StepCount steps) {
    if (anyHit && hit.prim != kNone) return true;
    TreeParts parts = partsOf(tree);
    ScaledRay scaled = scaledRay(ray, tree.at.exponent);
    int tExponent = scaled.tExponent - unit;
    Best best = bestOf(scaledHit(hit, tExponent), scaled);
    bool finished = true;
    if (CLEAVE_TRAVERSAL == kStackTraversal) finished = traverseStack(parts, scaled, anyHit, best, steps);
    else if (CLEAVE_TRAVERSAL == kShortStackTraversal)
        finished = traverseShortStack(parts, scaled, anyHit, stepLimit, best, trail, steps);
    else finished = traverseRestart(parts, scaled, anyHit, stepLimit, best, trail, steps);
    // A hit that stays is not converted back: scaling may have moved its t out of the range of floats.
    if (best.index != kNone) hit = worldHit(hitOf(parts, scaled, best), tExponent);
    return finished;
}

Ray rayOf(vec3 origin, float tMin, vec3 direction, float tMax) {
    Ray ray;
    ray.origin = origin;
    ray.tMin = tMin;
    ray.direction = direction;
    ray.tMax = tMax;
    return ray;
}

// The answer to a query that begins and ends here.
Hit answer(Tree tree, vec3 origin, float tMin, vec3 direction, float tMax, bool anyHit) {
    Ray ray = rayOf(origin, tMin, direction, tMax);
    Hit hit = missedHit();
    if (!isValidRay(ray)) return hit;
    Trail trail = emptyTrail();
    StepCount steps = noSteps();
    return search(tree, ray, 0, anyHit, CLEAVE_STEP_LIMIT, hit, trail, steps) ? hit : missedHit();
}

// The closest hit with tMin <= t <= tMax; ties go to the lower triangle number. The direction need not be of unit
// length. A miss, as for a ray that is not valid, has t = +inf and prim = 0xFFFFFFFF.
Hit trace(Tree tree, vec3 origin, float tMin, vec3 direction, float tMax) {
    return answer(tree, origin, tMin, direction, tMax, false);
}

// Whether there is a hit with tMin <= t <= tMax.
bool occluded(Tree tree, vec3 origin, float tMin, vec3 direction, float tMax) {
    return answer(tree, origin, tMin, direction, tMax, true).prim != kNone;
}

// All hits with tMin <= t <= tMax, one after the other, in the order of t and then of triangle numbers; a miss ends
// them. A ray through an edge or a vertex of a closed surface hits one of the triangles there, or as many as it enters
// and leaves through (crossing.h), so that their number is even:
//     for (Hit hit = cleaveFirst(...); hit.prim != kNone; hit = cleaveNext(..., hit))
// The names have their prefix here already, since the plain words are those of many variables.
Hit cleaveFirst(Tree tree, vec3 origin, float tMin, vec3 direction, float tMax) {
    return crossingBehind(tree, rayOf(origin, tMin, direction, tMax), beforeAll());
}
Hit cleaveNext(Tree tree, vec3 origin, float tMin, vec3 direction, float tMax, Hit last) {
    return crossingBehind(tree, rayOf(origin, tMin, direction, tMax), markAt(last));
}

// How many of these hits there are; 0 for a ray that is not valid.
uint cleaveCount(Tree tree, vec3 origin, float tMin, vec3 direction, float tMax) {
    Ray ray = rayOf(origin, tMin, direction, tMax);
    return isValidRay(ray) ? uint(crossings(tree, ray, false)) : 0u;
}

// How many of them leave, along the normal (b - a) x (c - a) of their triangle, less those that enter. From a point
// without an end this is how often a closed surface winds around it.
int cleaveWinding(Tree tree, vec3 origin, float tMin, vec3 direction, float tMax) {
    Ray ray = rayOf(origin, tMin, direction, tMax);
    return isValidRay(ray) ? crossings(tree, ray, true) : 0;
}
#endif
