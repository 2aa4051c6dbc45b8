// What a kernel says that traces rays through a scene of places, before it includes cleave.glsl.
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/placed_mesh.h"

vec3 placedHere(vec3 vertex);
uint numberHere(uint number);
bool hasNoArea(vec3 a, vec3 b, vec3 c);
void rayHere(inout vec3 origin, inout float tMin, inout vec3 direction, inout float tMax, inout float error);
float tHere(float t);

#define CLEAVE_INSTANCES true
#define CLEAVE_PLACED_VERTEX placedHere
#define CLEAVE_PLACED_NUMBER numberHere
#define CLEAVE_LEAVES_OUT hasNoArea
#define CLEAVE_PLACED_RAY rayHere
#define CLEAVE_PLACED_T tHere
