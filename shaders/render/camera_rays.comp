#version 460
// Makes a ray through each pixel: through its centre, or where one of several samples is. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

void main() {
    uint i = rayIndex();
    if (i >= push.end) return;
    ImageCamera camera = args.camera;
    uint pixel = pixelOf(i, camera.width, camera.height);
    uint x = pixel % camera.width;
    uint y = pixel / camera.width;
    vec2 place = placeInPixel(args.samples, args.settings.seed, pixel, push.path);
    args.rays.at[i] = imageRay(camera, double(x) + double(place.x), double(y) + double(place.y));
}
