// The body of the trace kernels. They are compiled from cleave.glsl, the file that users include.
#include "shared/config.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(constant_id = 0) const bool kAnyHit = false;
layout(constant_id = 1) const bool kCountSteps = false;
layout(constant_id = 2) const uint kTriangleTest = 0u;

#define CLEAVE_COUNT_STEPS kCountSteps
#define CLEAVE_TEST kTriangleTest
#define CLEAVE_CROSSINGS false
// TRACES_LAZILY: rays wait at leaves that were left open.
#ifdef TRACES_LAZILY
bool marksOpen(uint node);
#define CLEAVE_LAZY true
#define CLEAVE_IS_OPEN marksOpen
#endif
#include "cleave.glsl"
#include "trace_push.glsl"
// TRACES_INSTANCES: what is traced is a scene of places, and not a tree.
#ifdef TRACES_INSTANCES
#include "lib/instances.glsl"
#endif

// CLEAVE_MORE_PUSH: what a kernel is given beside it.
#ifndef CLEAVE_MORE_PUSH
#define CLEAVE_MORE_PUSH
#endif
layout(push_constant, scalar) uniform Push { CleaveTracePush push; CLEAVE_MORE_PUSH };

#ifdef TRACES_LAZILY
// Whether a leaf is open; then it is marked, to be built further.
bool marksOpen(uint node) {
    if (node >= push.open.at[0] || push.open.at[node + 1u] == 0u) return false;
    push.open.at[node + 1u] = kCleaveMarkedNode;
    return true;
}
#endif

bool has(uint flag) { return (push.flags & flag) != 0u; }

// A ray that comes from another tree was counted there, if it is not valid.
void count(bool valid, bool finished) {
    if (!valid && !has(kCleaveTraceFromHits)) atomicAdd(push.counters.at.invalidRays, 1u);
    if (!finished) atomicAdd(push.counters.at.unfinishedRays, 1u);
}

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    bool resumes = has(kCleaveTraceResumes);
    CleaveTrail trail = cleaveEmptyTrail();
    if (resumes) trail = push.trails.at[i];
    if (cleaveIsFinished(trail)) return;
    bool goesOn = resumes || has(kCleaveTraceFromHits);
    CleaveHit hit = cleaveMissedHit();
    if (goesOn) hit = push.hits.at[i];
    CleaveStepCount steps = cleaveNoSteps();
    if (kCountSteps && goesOn) steps = push.steps.at[i];

    CleaveRay ray = push.rays.at[i];
    bool valid = cleaveIsValidRay(ray);
    bool finished = true;
    int unit = has(kCleaveTraceBetween) ? push.hitExponent - cleaveDirectionExponent(ray) : 0;
#ifdef TRACES_INSTANCES
    if (valid) searchInstances(PlacedSceneRef(uvec2(push.tree)), ray, kAnyHit, hit, steps);
#else
    if (valid) finished = cleaveSearch(push.tree, ray, unit, kAnyHit, push.stepLimit, hit, trail, steps);
#endif
    if (!valid || !(finished || has(kCleaveTraceTrails))) hit = cleaveMissedHit();
    if (has(kCleaveTraceLast)) hit = cleaveWorldHit(hit, unit);

    if (has(kCleaveTraceCounters)) count(valid, finished);
    if (has(kCleaveTraceTrails)) push.trails.at[i] = finished ? cleaveFinishedTrail() : trail;
    push.hits.at[i] = hit;
    if (kCountSteps) push.steps.at[i] = steps;
}
