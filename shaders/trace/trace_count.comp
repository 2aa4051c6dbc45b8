#version 460
// Counts the crossings of each ray, by the rule "once" (shared/crossing.h). An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "shared/config.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(constant_id = 0) const bool kSigned = false;
#include "cleave.glsl"
#include "trace_push.glsl"

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Counts { int at[]; };
layout(push_constant, scalar) uniform Push { CleaveTracePush push; };

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    CleaveRay ray = push.rays.at[i];
    bool valid = cleaveIsValidRay(ray);
    if (!valid && (push.flags & kCleaveTraceCounters) != 0u) atomicAdd(push.counters.at.invalidRays, 1u);
    Counts(push.hits).at[i] = valid ? cleaveCrossings(push.tree, ray, kSigned) : 0;
}
