#version 460
#extension GL_GOOGLE_include_directive : require
#include "cleave.glsl"
#include "own_names.glsl"

layout(location = 0) in vec3 point;
layout(location = 0) out vec4 colour;
layout(push_constant) uniform Push { Tree tree; };

void main() {
    Hit hit = trace(tree, Ray(point, vec3(0.0)));
    if (hit.shadowed) discard;
    colour = vec4(hit.point, 1.0);
}
