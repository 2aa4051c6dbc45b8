// What the trace kernel is given.
#ifndef CLEAVE_SHARED_TRACE_H
#define CLEAVE_SHARED_TRACE_H
#include "config.h"
#include "kd_node.h"
#include "triangle.h"

CLEAVE_BEGIN

// Triangle tests of the trace kernels: intersectTriangle; plainTriangle, quick and leaky; and resolveTriangle without
// the filter in float before it.
CLEAVE_CONST uint kWatertightTest = 0u;
CLEAVE_CONST uint kPlainTest = 1u;
CLEAVE_CONST uint kUnfilteredTest = 2u;

// What a ray did; counted by a variant of the kernel that is used only where asked for.
struct StepCount {
    uint inner;      // inner nodes visited, those of restarts included
    uint leaves;     // leaves visited
    uint triangles;  // triangle tests
    uint restarts;
    uint hitLeaf;   // triangles in the leaf of the hit
    uint resolved;  // triangle tests that were decided in double
};
CLEAVE_SIZE(StepCount, 24);

struct TraceCounters {
    uint invalidRays;
    uint cappedRays;
};
CLEAVE_SIZE(TraceCounters, 8);

#ifndef __cplusplus
#include "lib/trace_arrays.glsl"
#endif

struct TracePush {
    CLEAVE_ADDRESS(RayArray) rays;
    CLEAVE_ADDRESS(HitArray) hits;
    CLEAVE_ADDRESS(StepCountArray) steps;
    CLEAVE_ADDRESS(TraceCountersRef) counters;
    CLEAVE_ADDRESS(KdNodeArray) nodes;
    CLEAVE_ADDRESS(UintArray) leafTriangles;
    CLEAVE_ADDRESS(TriangleArray) triangles;
    Box bounds;
    int exponent;  // scaled space to world
    uint rayCount;
};
CLEAVE_SIZE(TracePush, 88);

CLEAVE_END
#endif
