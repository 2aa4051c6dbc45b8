#version 460
// Traces rays through a scene of places, each tree with a short stack in registers.
#extension GL_GOOGLE_include_directive : require
#define TRACES_INSTANCES
#include "lib/instances_before.glsl"
#define WALK(tree, ray, anyHit, best, trail, steps) \
    cleaveTraverseShortStack(tree, ray, anyHit, 0xFFFFFFFFu, best, trail, steps)
#include "lib/trace_main.glsl"
