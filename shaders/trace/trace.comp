#version 460
// Closest or any hit of each ray, without a stack. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/trace.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;

#include "lib/restart.glsl"
#include "lib/trace_main.glsl"
