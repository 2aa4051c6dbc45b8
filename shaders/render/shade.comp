#version 460
// Colours each pixel from its hit. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

vec3 colourOf(uint i) {
    Ray ray = args.rays.at[i];
    Hit hit = args.hits.at[i];
    bool found = hit.prim != kNone;
    ViewScale scale = viewScale(state.lowBits, state.highBits);
    if (args.view == kViewSteps) {
        return scaleColour(onScale(float(shownCount(args.view, args.steps.at[i])), scale.low, scale.high));
    }
    if (!found) return args.view == kViewShaded ? encoded(backgroundColour(ray.direction)) : vec3(0.0);
    if (args.view == kViewLeaves) {
        return scaleColour(onScale(float(shownCount(args.view, args.steps.at[i])), scale.low, scale.high));
    }
    if (args.view == kViewDepth) return vec3(1.0 - 0.9 * onScale(hit.t, scale.low, scale.high));
    vec3 normal = facingNormal(hitTriangle(hit), ray.direction);
    if (args.view == kViewNormals) return 0.5 * normal + 0.5;
    vec3 base = args.baseColours.at[args.materialOf.at[hit.prim]].xyz;
    return encoded(shadedColour(base, normal, args.shadowHits.at[i].prim == kNone));
}

void main() {
    uint i = rayIndex();
    if (i >= args.count) return;
    args.pixels.at[pixelOf(i, args.camera.width, args.camera.height)] = packedColour(colourOf(i));
}
