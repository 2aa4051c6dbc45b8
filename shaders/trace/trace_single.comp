#version 460
// Finds the closest hit or any hit of each ray in a tree of a single leaf. An invocation per ray.
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "lib/trace_single.glsl"
