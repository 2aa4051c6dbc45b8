// Queries of points and boxes and the arguments of their kernels, with the prefixed names of cleave.glsl. Include that and
// trace_push.glsl first. This file is generated.
#ifndef CLEAVE_QUERY_PUSH_GLSL
#define CLEAVE_QUERY_PUSH_GLSL
#include "lib/point_queries.glsl"
#include "shared/overlap.h"
#include "shared/query.h"
#endif
