#version 460
// Finds the closest hit or any hit of each ray of a picture that looks through something, without a stack.
#extension GL_GOOGLE_include_directive : require
#include "lib/trace_alpha.glsl"
