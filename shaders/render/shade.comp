#version 460
// The colour of each pixel, from its hit. An invocation per pixel.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/shade.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(push_constant, scalar) uniform Push { ShadePush push; };

vec3 colourOf(uint i) {
    Ray ray = push.rays.at[i];
    Hit hit = push.hits.at[i];
    bool found = hit.prim != kNone;
    if (push.view == kViewSteps) {
        StepCount s = push.steps.at[i];
        return scaleColour(onScale(float(s.inner + s.leaves), push.scaleLow, push.scaleHigh));
    }
    if (!found) return push.view == kViewShaded ? encoded(backgroundColour(ray.direction)) : vec3(0.0);
    if (push.view == kViewLeaves) {
        return scaleColour(onScale(float(push.steps.at[i].hitLeaf), push.scaleLow, push.scaleHigh));
    }
    if (push.view == kViewDepth) return vec3(1.0 - 0.9 * onScale(hit.t, push.scaleLow, push.scaleHigh));
    vec3 normal = facingNormal(push.triangles.at[hit.prim], ray.direction);
    if (push.view == kViewNormals) return 0.5 * normal + 0.5;
    vec3 base = push.baseColours.at[push.materialOf.at[hit.prim]].xyz;
    return encoded(shadedColour(base, normal, push.shadowHits.at[i].prim == kNone));
}

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    push.pixels.at[i] = packedColour(colourOf(i));
}
