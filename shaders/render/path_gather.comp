#version 460
// Adds the light that reaches each path's surface straight from a light, if nothing is between. An invocation per shadow
// ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

void main() {
    uint i = rayIndex();
    if (i >= push.end || args.shadowHits.at[i].prim != kNone) return;
    uint path = args.shadowPaths.at[i];
    args.radiance.at[path] = args.radiance.at[path] + args.direct.at[i];
}
