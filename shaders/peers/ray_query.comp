#version 460
// Asks the driver for the closest hit or any hit of each ray, by a ray query. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require
#include "lib/peer_query.glsl"
