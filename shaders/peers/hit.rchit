#version 460
// Notes what a ray of the ray-tracing pipeline hits.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_tracing : require
#include "lib/peer_trace.glsl"

layout(location = 0) rayPayloadInEXT Hit hit;
hitAttributeEXT vec2 weights;

void main() {
    hit.t = gl_HitTEXT;
    hit.prim = uint(gl_PrimitiveID);
    hit.u = weights.x;
    hit.v = weights.y;
}
