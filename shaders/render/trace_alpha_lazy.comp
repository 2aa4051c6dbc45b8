#version 460
// Traces rays of a picture that looks through something, without a stack, in a tree that is built where rays come to.
#extension GL_GOOGLE_include_directive : require
#define TRACES_LAZILY
#include "lib/trace_alpha.glsl"
