#version 460
// Tells of each point whether it is inside. An invocation per point.
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
    push.answers.at[i] = cleaveContains(push.tree, point) ? 1u : 0u;
}
