#version 460
// Traces rays through a scene of places, each tree with a stack per invocation.
#extension GL_GOOGLE_include_directive : require
#define TRACES_INSTANCES
#include "lib/instances_before.glsl"
#define WALK(tree, ray, anyHit, best, trail, steps) \
    cleaveTraverseStack(tree, ray, anyHit, best, steps)
#include "lib/trace_main.glsl"
