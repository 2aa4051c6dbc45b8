#version 460
// Finds the ends of the scale of depths: the nearest hit, and the farthest reach of a ray that hits. An invocation per
// ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

shared uint lowBits;
shared uint highBits;

void main() {
    if (gl_LocalInvocationID.x == 0u) {
        lowBits = 0u;
        highBits = 0u;
    }
    barrier();
    uint i = rayIndex();
    if (i < push.end) {
        Hit hit = args.hits.at[i];
        if (hit.prim != kNone) {
            atomicMax(lowBits, ~orderedBits(hit.t));
            atomicMax(highBits, orderedBits(depthReach(args.rays.at[i], hit, args.bounds, args.exponent)));
        }
    }
    barrier();
    if (gl_LocalInvocationID.x != 0u || highBits == 0u) return;
    atomicMax(state.lowBits, lowBits);
    atomicMax(state.highBits, highBits);
}
