#version 460
// Makes the ray through each pixel's centre. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

void main() {
    uint i = rayIndex();
    if (i >= args.count) return;
    ImageCamera camera = args.camera;
    uint pixel = pixelOf(i, camera.width, camera.height);
    uint x = pixel % camera.width;
    uint y = pixel / camera.width;
    args.rays.at[i] = imageRay(camera, double(x) + 0.5lf, double(y) + 0.5lf);
}
