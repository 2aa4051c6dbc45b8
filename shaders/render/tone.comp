#version 460
// Makes the colour of each pixel from the mean of its samples. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

void main() {
    uint i = rayIndex();
    if (i >= push.end) return;
    vec4 unlit = vec4(0.0);
    if (isOfLight(args.view)) unlit = args.unlit.at[i];
    args.pixels.at[pixelOf(i, args.camera.width, args.camera.height)] =
        packedColour(shownColour(args.view, args.radiance.at[i], unlit, push.path, args.exposure));
}
