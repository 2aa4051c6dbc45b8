#version 460
// Closest or any hit of each ray. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/trace.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(constant_id = 0) const bool kAnyHit = false;
layout(constant_id = 1) const bool kCountSteps = false;
layout(push_constant, scalar) uniform Push { TracePush push; };

#include "lib/restart.glsl"

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    Ray ray = push.rays.at[i];
    StepCount steps = StepCount(0u, 0u, 0u, 0u, 0u);
    Hit hit = missedHit();
    if (isValidRay(ray)) {
        ScaledRay scaled = scaledRay(ray, push.exponent);
        bool capped;
        hit = worldHit(traverse(scaled, steps, capped), scaled.tExponent);
        if (capped) atomicAdd(push.counters.at.cappedRays, 1u);
    } else {
        atomicAdd(push.counters.at.invalidRays, 1u);
    }
    push.hits.at[i] = hit;
    if (kCountSteps) push.steps.at[i] = steps;
}
