// Multiplies by powers of two exactly. Scenes and rays are brought to about unit size this way. The arithmetic is that
// of integers, so that it also works where a device flushes denormals and where the factor itself is not a float.
#ifndef CLEAVE_SHARED_SCALE_H
#define CLEAVE_SHARED_SCALE_H
#include "language.h"

CLEAVE_BEGIN

CLEAVE_CONST int kZeroExponent = -1000;  // binaryExponent of a zero

// Returns e with 2^e <= |x| < 2^(e+1) for finite x, denormals included, and kZeroExponent for +-0.
CLEAVE_FN int binaryExponent(float x) {
    uint b = floatBitsToUint(x) & 0x7FFFFFFFu;
    if (b == 0u) return kZeroExponent;
    int e = int(b >> 23) - 127;
    if (e > -127) return e;
    e = -127;
    while ((b & 0x00400000u) == 0u) {
        b = b << 1;
        e = e - 1;
    }
    return e;
}

// Returns x * 2^n: infinity where that overflows, +0 where it is below the smallest normal number. Infinities and NaN
// stay as they are; -0 becomes +0, so that no later test sees its sign.
CLEAVE_FN float timesPowerOfTwo(float x, int n) {
    uint b = floatBitsToUint(x);
    uint sign = b & 0x80000000u;
    uint magnitude = b & 0x7FFFFFFFu;
    if (magnitude >= 0x7F800000u) return x;
    int e = binaryExponent(x);
    if (e == kZeroExponent) return 0.0f;
    uint mantissa = e > -127 ? magnitude & 0x007FFFFFu : (magnitude << uint(-126 - e)) & 0x007FFFFFu;
    e = e + n;
    if (e > 127) return uintBitsToFloat(sign | 0x7F800000u);
    if (e < -126) return 0.0f;
    return uintBitsToFloat(sign | uint(e + 127) << 23 | mantissa);
}

CLEAVE_FN vec3 timesPowerOfTwo(vec3 v, int n) {
    return vec3(timesPowerOfTwo(v.x, n), timesPowerOfTwo(v.y, n), timesPowerOfTwo(v.z, n));
}

CLEAVE_END
#endif
