#version 460
// Makes a ray from each hit towards the sun. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

void main() {
    uint i = rayIndex();
    if (i >= push.end) return;
    Hit hit = args.hits.at[i];
    Triangle t = Triangle(vec3(0.0), vec3(0.0), vec3(0.0));
    if (hit.prim != kNone) t = args.triangles.at[hit.prim];
    args.shadowRays.at[i] = shadowRay(args.rays.at[i], hit, t);
}
