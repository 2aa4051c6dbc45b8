#version 460
// Adds the light that reaches each path's surface straight from a light, if nothing is between. An invocation per path.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

void main() {
    uint i = rayIndex();
    if (i >= args.count || args.shadowHits.at[i].prim != kNone) return;
    args.radiance.at[i] = args.radiance.at[i] + args.direct.at[i];
}
