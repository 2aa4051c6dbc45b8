#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_tracing : require
#define CLEAVE_TEST kCleavePlainTest
#define CLEAVE_TRAVERSAL kCleaveStackTraversal
#define CLEAVE_STEP_LIMIT 1000u
#include "cleave.glsl"
#include "own_names.glsl"

layout(location = 0) rayPayloadInEXT bool shadowed;
layout(push_constant) uniform Push { Tree tree; };

void main() {
    vec3 point = gl_WorldRayOriginEXT + gl_HitTEXT * gl_WorldRayDirectionEXT;
    shadowed = trace(tree, Ray(point, vec3(0.0))).shadowed;
}
