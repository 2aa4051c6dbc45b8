#version 460
// Does the same with a stack: rays that wait begin anew.
#extension GL_GOOGLE_include_directive : require
#define TRACES_LAZILY
#define CLEAVE_TRAVERSAL kCleaveStackTraversal
#include "lib/trace_alpha.glsl"
