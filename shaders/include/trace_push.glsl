// Arguments of the trace kernels, with the prefixed names of cleave.glsl. Include that first. This
// file is generated.
#ifndef CLEAVE_TRACE_PUSH_GLSL
#define CLEAVE_TRACE_PUSH_GLSL
#include "shared/trace.h"
#include "shared/trail.h"
#endif
