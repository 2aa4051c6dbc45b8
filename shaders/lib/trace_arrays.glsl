// Included where shared/trace.h has declared what these hold.
#include "lib/arrays.glsl"

CLEAVE_ARRAY(RayArray, Ray);
CLEAVE_ARRAY(HitArray, Hit);
CLEAVE_ARRAY(StepCountArray, StepCount);
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer TraceCountersRef { TraceCounters at; };
