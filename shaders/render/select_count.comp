#version 460
// Selects one byte of the count at which the scale ends, from a histogram: four rounds of these two kernels are a radix
// selection. One invocation.
#extension GL_GOOGLE_include_directive : require
#include "lib/picture.glsl"

layout(local_size_x = 1) in;

void main() {
    uint total = 0u;
    for (uint k = 0u; k < 256u; k++) total += state.histogram[k];
    if (push.round == 0u) state.rank = scaleRank(total);
    uint rank = state.rank;
    uint byte = 0u;
    while (byte < 255u && rank >= state.histogram[byte]) {
        rank -= state.histogram[byte];
        byte++;
    }
    for (uint k = 0u; k < 256u; k++) state.histogram[k] = 0u;
    state.rank = rank;
    state.prefix = state.prefix << 8 | byte;
    if (push.round < 3u || total == 0u) return;
    state.lowBits = ~orderedBits(0.0);
    state.highBits = orderedBits(float(state.prefix));
}
