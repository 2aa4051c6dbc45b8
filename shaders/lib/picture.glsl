// Every kernel of a picture starts with this.
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/picture_args.h"
#include "shared/tone.h"
#include "lib/group.glsl"

layout(push_constant, scalar) uniform Push { PicturePush push; };

#define args push.args.at
#define state args.state.at

#include "lib/surface.glsl"

// The number of this invocation's ray; not below push.end: there is none.
uint rayIndex() { return push.first + groupIndex() * kGroup + gl_LocalInvocationID.x; }

// The triangle of a hit in the scaled space of the scene, where it neither overflows nor vanishes.
Triangle hitTriangle(Hit hit) { return scaledTriangle(args.triangles.at[hit.prim], -args.exponent); }
