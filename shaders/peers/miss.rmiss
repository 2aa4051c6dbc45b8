#version 460
// Notes that a ray of the ray-tracing pipeline misses.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_tracing : require
#include "lib/peer_trace.glsl"

layout(location = 0) rayPayloadInEXT Hit hit;

void main() { hit = missedHit(); }
