#version 460
// Finds hits of rays of a picture that looks through something, in a tree of a single leaf.
#extension GL_GOOGLE_include_directive : require
#define TRACES_SINGLE
#include "lib/trace_alpha.glsl"
