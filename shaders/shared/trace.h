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
CLEAVE_CONST uint kTraceBetween = 16u;  // the t of hits is in units of 2^(hitExponent - exponent of the direction)
CLEAVE_CONST uint kTraceLast = 32u;     // likewise, but for the hits that are written

// What the kernels that wait are told of the nodes of a tree: how many there are, then a word of each. Those behind
// them are closed, too.
CLEAVE_CONST uint kClosedNode = 0u;
CLEAVE_CONST uint kOpenNode = 1u;
CLEAVE_CONST uint kMarkedNode = 2u;  // open, and a ray waits

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
    CLEAVE_ADDRESS(UintArray) open;             // used by the kernels that wait
    uint rayCount;
    uint stepLimit;  // inner nodes and triangle tests after which a ray is given up
    uint flags;
    uint hitsPerRay;  // of the kernel that finds all
    int hitExponent;  // used with kTraceBetween
    uint reserved;
};
CLEAVE_SIZE(TracePush, 80);

CLEAVE_END
#endif
