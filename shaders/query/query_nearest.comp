#version 460
// Finds the nearest triangle of each point. An invocation per point.
#extension GL_GOOGLE_include_directive : require
#include "shared/config.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
#include "cleave.glsl"
#include "trace_push.glsl"
#include "query_push.glsl"

layout(push_constant, scalar) uniform Push { CleaveQueryPush push; };

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    vec3 point = vec3(push.items.at[3u * i], push.items.at[3u * i + 1u], push.items.at[3u * i + 2u]);
    push.nearest.at[i] = cleaveNearest(push.tree, point, push.within);
}
