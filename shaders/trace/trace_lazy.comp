#version 460
// Traces rays, without a stack, through a tree that is built where rays come to.
#extension GL_GOOGLE_include_directive : require
#define TRACES_LAZILY
#include "lib/trace_main.glsl"
