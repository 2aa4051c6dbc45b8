#version 460
// Counts, for the scale of counts, how often each value of one of their bytes occurs among those that begin with what is
// known of the count that is being selected. An invocation per ray.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = kGroup) in;

shared uint counters[256];

void main() {
    uint lane = gl_LocalInvocationID.x;
    for (uint k = lane; k < 256u; k += kGroup) counters[k] = 0u;
    barrier();
    uint i = rayIndex();
    if (i < push.end && countsInScale(args.view, args.hits.at[i])) {
        uint count = shownCount(args.view, args.steps.at[i]);
        uint shift = 24u - 8u * push.round;
        if (push.round == 0u || count >> (shift + 8u) == state.prefix) atomicAdd(counters[count >> shift & 255u], 1u);
    }
    barrier();
    for (uint k = lane; k < 256u; k += kGroup) {
        if (counters[k] != 0u) atomicAdd(state.histogram[k], counters[k]);
    }
}
