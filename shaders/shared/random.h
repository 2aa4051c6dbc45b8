// Random numbers without a state: each is a hash of what it is for, so that it depends on neither order nor device.
#ifndef CLEAVE_SHARED_RANDOM_H
#define CLEAVE_SHARED_RANDOM_H
#include "language.h"

CLEAVE_BEGIN

// Hashes three words to three: a step of a linear congruential generator and two rounds of mixing (pcg3d of Jarzynski
// and Olano 2020). Distinct words give distinct hashes, since every step can be undone.
CLEAVE_FN uvec3 pcg3d(uvec3 words) {
    uint x = words.x * 1664525u + 1013904223u;
    uint y = words.y * 1664525u + 1013904223u;
    uint z = words.z * 1664525u + 1013904223u;
    x = x + y * z;
    y = y + z * x;
    z = z + x * y;
    x = x ^ x >> 16;
    y = y ^ y >> 16;
    z = z ^ z >> 16;
    x = x + y * z;
    y = y + z * x;
    z = z + x * y;
    return uvec3(x, y, z);
}

// The upper 24 bits as a multiple of 2^-24 in [0, 1), which float holds exactly.
CLEAVE_FN float unitFloat(uint bits) { return float(bits >> 8) * 5.9604644775390625e-08f; }

// Three numbers, uniform in [0, 1), for one decision of a pixel's path: `path` counts the paths of the pixel,
// `dimension` the decisions along one.
CLEAVE_FN vec3 sampleNumbers(uint pixel, uint path, uint dimension) {
    uvec3 bits = pcg3d(uvec3(pixel, path, dimension));
    return vec3(unitFloat(bits.x), unitFloat(bits.y), unitFloat(bits.z));
}

// The first of them, where one is enough.
CLEAVE_FN float sampleNumber(uint pixel, uint path, uint dimension) {
    return unitFloat(pcg3d(uvec3(pixel, path, dimension)).x);
}

CLEAVE_END
#endif
