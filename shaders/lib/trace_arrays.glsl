// Arrays of the trace kernels. Included where shared/trace.h has declared their elements.
#ifndef CLEAVE_LIB_TRACE_ARRAYS
#define CLEAVE_LIB_TRACE_ARRAYS
#include "lib/arrays.glsl"

CLEAVE_ARRAY(RayArray, Ray);
CLEAVE_ARRAY(HitArray, Hit);
CLEAVE_ARRAY(StepCountArray, StepCount);
CLEAVE_ARRAY(TrailArray, Trail);
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer TraceCountersRef { TraceCounters at; };
#endif
