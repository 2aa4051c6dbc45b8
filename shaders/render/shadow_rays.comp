#version 460
// Makes a ray from each hit towards the sun and, in pictures of several samples, one to the light from all around; these
// come after all of the former. An invocation per pixel.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"
#include "shared/light_rays.h"

layout(local_size_x = kGroup) in;

void main() {
    uint i = rayIndex();
    if (i >= push.end) return;
    Hit hit = args.hits.at[i];
    LightRays made = noLightRays();
    if (hit.prim != kNone) {
        uint pixel = pixelOf(i, args.camera.width, args.camera.height);
        made = lightRays(args.rays.at[i], hit, args.triangles.at[hit.prim], hitTriangle(hit), args.samples,
                         args.ambientReach, pixel, push.path ^ args.settings.seed);
    }
    args.shadowRays.at[i] = made.sun;
    if (args.samples > 1u) args.shadowRays.at[args.count + i] = made.around;
}
