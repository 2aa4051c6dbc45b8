#version 460
// A ray from each hit towards the sun. An invocation per pixel.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/shade.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(push_constant, scalar) uniform Push { ShadePush push; };

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    Hit hit = push.hits.at[i];
    Triangle t = Triangle(vec3(0.0), vec3(0.0), vec3(0.0));
    if (hit.prim != kNone) t = push.triangles.at[hit.prim];
    push.shadowRays.at[i] = shadowRay(push.rays.at[i], hit, t, push.offset);
}
