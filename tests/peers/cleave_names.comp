#version 460
// Does what shaders/peers/ray_query.comp does, with cleave's ray queries instead of the driver's.
#extension GL_GOOGLE_include_directive : require
#include "cleave_ray_query.glsl"
#include "lib/peer_query.glsl"
