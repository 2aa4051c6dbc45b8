#version 460
// Adds the colour of each hit to what its pixel has gathered. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

bool showsUnlit(Hit hit) {
    return hit.prim != kNone && (materialOf(surfaceArrays(), hit.prim).flags & kMaterialUnlit) != 0u;
}

vec3 colourOf(uint i) {
    Ray ray = args.rays.at[i];
    Hit hit = args.hits.at[i];
    bool found = hit.prim != kNone;
    ViewScale scale = viewScale(state.lowBits, state.highBits);
    if (args.view == kViewSteps) {
        return scaleColour(onScale(float(shownCount(args.view, args.steps.at[i])), scale.low, scale.high));
    }
    if (!found) return args.view == kViewShaded ? backgroundColour(ray.direction) : vec3(0.0);
    if (args.view == kViewLeaves) {
        return scaleColour(onScale(float(shownCount(args.view, args.steps.at[i])), scale.low, scale.high));
    }
    if (args.view == kViewDepth) return vec3(1.0 - 0.9 * onScale(hit.t, scale.low, scale.high));
    if (args.view == kViewNormals) return 0.5 * facingNormal(hitTriangle(hit), ray.direction) + 0.5;
    HitSurface point = hitSurface(surfaceArrays(), kParts, hit, hitTriangle(hit), ray.direction);
    bool open = args.samples == 1u || args.shadowHits.at[args.count + i].prim == kNone;
    return shadedColour(point, args.shadowRays.at[i].direction, args.shadowHits.at[i].prim == kNone, open);
}

void main() {
    uint i = rayIndex();
    // Where rays go on in a further dispatch, this pass is run again after it.
    if (i >= push.end || state.primary.unfinishedRays + state.shadow.unfinishedRays > 0u) return;
    vec3 colour = colourOf(i);
    bool unlit = isOfLight(args.view) && showsUnlit(args.hits.at[i]);
    vec3 before = push.path == 0u ? vec3(0.0) : args.radiance.at[i];
    args.radiance.at[i] = unlit ? before : before + colour;
    if (!isOfLight(args.view)) return;
    vec4 others = push.path == 0u ? vec4(0.0) : args.unlit.at[i];
    args.unlit.at[i] = unlit ? others + vec4(colour, 1.0) : others;
}
