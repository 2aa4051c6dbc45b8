// Arguments and counters of the trace kernels.
#ifndef CLEAVE_SHARED_TRACE_H
#define CLEAVE_SHARED_TRACE_H
#include "config.h"
#include "step_count.h"
#include "trail.h"
#include "tree.h"

CLEAVE_BEGIN

struct TraceCounters {
    uint invalidRays;     // answered as misses
    uint unfinishedRays;  // given up at the step limit
};
CLEAVE_SIZE(TraceCounters, 8);

// TracePush.flags.
CLEAVE_CONST uint kTraceFromHits = 1u;  // goes on from the hits that are there
CLEAVE_CONST uint kTraceResumes = 2u;   // goes on from hits and trails, and leaves finished rays alone
CLEAVE_CONST uint kTraceTrails = 4u;    // writes trails, so that unfinished rays can be resumed
CLEAVE_CONST uint kTraceCounters = 8u;  // counts rays

#ifndef __cplusplus
#include "lib/trace_arrays.glsl"
#endif

struct TracePush {
    CLEAVE_ADDRESS(Tree) tree;
    CLEAVE_ADDRESS(RayArray) rays;
    CLEAVE_ADDRESS(HitArray) hits;              // hitsPerRay of each; where crossings are counted, an int of each
    CLEAVE_ADDRESS(StepCountArray) steps;       // used by the kernels that count steps
    CLEAVE_ADDRESS(TraceCountersRef) counters;  // used with kTraceCounters
    CLEAVE_ADDRESS(TrailArray) trails;          // one per ray; used with kTraceTrails and kTraceResumes
    uint rayCount;
    uint stepLimit;  // inner nodes and triangle tests after which a ray is given up
    uint flags;
    uint hitsPerRay;  // of the kernel that finds all
};
CLEAVE_SIZE(TracePush, 64);

CLEAVE_END
#endif
