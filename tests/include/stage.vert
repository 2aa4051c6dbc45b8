#version 460
#extension GL_GOOGLE_include_directive : require
#include "cleave.glsl"
#include "own_names.glsl"

layout(location = 0) in vec3 vertex;
layout(push_constant) uniform Push { Tree tree; };

void main() { gl_Position = vec4(trace(tree, Ray(vertex, vec3(0.0))).point, 1.0); }
