#version 460
// Does the same with a stack per invocation.
#extension GL_GOOGLE_include_directive : require
#define CLEAVE_TRAVERSAL kCleaveStackTraversal
#include "lib/trace_main.glsl"
