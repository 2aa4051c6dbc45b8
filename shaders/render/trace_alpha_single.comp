#version 460
// Does the same in a tree of a single leaf.
#extension GL_GOOGLE_include_directive : require
#define TRACES_SINGLE
#include "lib/trace_alpha.glsl"
