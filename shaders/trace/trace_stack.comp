#version 460
// The same with a stack per invocation.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/trace.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;

#include "lib/stack.glsl"
#include "lib/trace_main.glsl"
