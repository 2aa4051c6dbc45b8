#version 460
// Traces rays through a scene of places.
#extension GL_GOOGLE_include_directive : require
#define TRACES_INSTANCES
#include "lib/instances_before.glsl"
#define WALK(tree, ray, anyHit, best, trail, steps) \
    cleaveTraverseRestart(tree, ray, anyHit, 0xFFFFFFFFu, best, trail, steps)
#include "lib/trace_main.glsl"
