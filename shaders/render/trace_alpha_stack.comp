#version 460
// Does the same with a stack.
#extension GL_GOOGLE_include_directive : require
#define CLEAVE_TRAVERSAL kCleaveStackTraversal
#include "lib/trace_alpha.glsl"
