#version 460
// Counts the triangles that meet each box, or writes their numbers where the box's begin. A triangle that several leaves
// list comes several times. An invocation per box.
#extension GL_GOOGLE_include_directive : require
#include "shared/config.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(constant_id = 0) const bool kWrites = false;
#include "cleave.glsl"
#include "trace_push.glsl"
#include "query_push.glsl"

layout(push_constant, scalar) uniform Push { CleaveQueryPush push; };

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    CleaveBox box;
    for (uint axis = 0u; axis < 3u; axis++) {
        box.lo[axis] = push.items.at[6u * i + axis];
        box.hi[axis] = push.items.at[6u * i + 3u + axis];
    }
    uint count = 0u;
    uint first = kWrites ? push.first.at[i] : 0u;
    if (cleaveIsBox(box))
        count = cleaveOverlaps(cleavePartsOf(push.tree), cleaveScaledBox(box, push.tree.at.exponent),
                               kWrites ? kCleaveWriteOverlaps : kCleaveCountOverlaps, push.triangles, first);
    if (!kWrites) push.answers.at[i] = count;
}
