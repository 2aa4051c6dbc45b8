#version 460
// Does the same in a tree that is built where rays come to.
#extension GL_GOOGLE_include_directive : require
#define TRACES_LAZILY
#include "lib/trace_alpha.glsl"
