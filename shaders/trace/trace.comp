#version 460
// Finds the closest hit or any hit of each ray, without a stack. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/trace_main.glsl"
