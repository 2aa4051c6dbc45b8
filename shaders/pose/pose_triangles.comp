#version 460
// Makes triangles of posed vertices. An invocation for each that moves.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/config.h"
#include "shared/pose.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(push_constant, scalar) uniform Push { PosePush push; };

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.triangleCount) return;
    uint to = 9u * push.numbers.at[i];
    for (uint corner = 0u; corner < 3u; corner++) {
        uint from = 3u * push.corners.at[3u * i + corner];
        for (uint axis = 0u; axis < 3u; axis++)
            push.triangles.at[to + 3u * corner + axis] = push.posed.at[from + axis];
    }
}
