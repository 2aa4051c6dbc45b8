// cleave.glsl: closest and any hits of rays in trees built by cleave, for shaders of any stage.
// MIT License, Copyright (c) 2026 The cleave authors.
//
//     #version 460
//     #extension GL_GOOGLE_include_directive : require
//     #include "cleave.glsl"
//     layout(push_constant) uniform Push { CleaveTree tree; };  // 8 bytes: the address that cmdBuild() was given
//     layout(location = 0) in vec3 origin;
//     layout(location = 1) in vec3 direction;
//     layout(location = 0) out vec4 colour;
//     void main() {
//         CleaveHit hit = cleaveTrace(tree, origin, 0.0, direction, 1.0e30);  // {float t; uint prim; float u, v}
//         vec3 point = origin + hit.t * direction;
//         bool lit = hit.prim != kCleaveNone && !cleaveOccluded(tree, point, 1.0e-3, vec3(0.0, 1.0, 0.0), 1.0e30);
//         colour = vec4(lit ? 1.0 : 0.0);
//     }
//
// It enables the extensions that it needs, so include it before the first declaration. It has no descriptors and no
// subgroup operations. The device features are bufferDeviceAddress, scalarBlockLayout and shaderFloat64. CLEAVE_TEST,
// CLEAVE_TRAVERSAL and CLEAVE_STEP_LIMIT may be defined before; see their defaults below. All global names begin with
// cleave, Cleave, kCleave or CLEAVE. This file is generated: change the sources of cleave instead.
#ifndef CLEAVE_GLSL
#define CLEAVE_GLSL
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/query.glsl"
#endif
