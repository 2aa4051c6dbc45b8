#version 460
// Does the same with a short stack.
#extension GL_GOOGLE_include_directive : require
#define CLEAVE_TRAVERSAL kCleaveShortStackTraversal
#include "lib/trace_alpha.glsl"
