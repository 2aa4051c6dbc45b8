#version 460
#extension GL_GOOGLE_include_directive : require
#include "cleave.glsl"
#include "own_names.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) buffer Points { vec4 points[]; };
layout(push_constant) uniform Push { Tree tree; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    Hit hit = trace(tree, Ray(points[i].xyz, vec3(0.0)));
    points[i] = vec4(hit.point, hit.shadowed ? 0.0 : 1.0);
}
