// Arrays in device memory, by address. Included where shared/trace.h has declared what they hold.
#define CLEAVE_ARRAY(Name, Type) \
    layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Name { Type at[]; }

CLEAVE_ARRAY(UintArray, uint);
CLEAVE_ARRAY(TriangleArray, Triangle);
CLEAVE_ARRAY(KdNodeArray, KdNode);
CLEAVE_ARRAY(RayArray, Ray);
CLEAVE_ARRAY(HitArray, Hit);
CLEAVE_ARRAY(StepCountArray, StepCount);
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer TraceCountersRef { TraceCounters at; };
