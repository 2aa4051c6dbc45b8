// Correctly rounded division. Vulkan grants division 2.5 ulp, so a quotient that shapes the tree is corrected by its
// exact residual (Dekker 1971), after which every device has the bits that IEEE division gives.
#ifndef CLEAVE_SHARED_DIV_ROUNDED_H
#define CLEAVE_SHARED_DIV_ROUNDED_H
#include "language.h"

CLEAVE_BEGIN

// a - q b for a q within a few ulp of a / b, exact up to the rounding of its last bits (Veltkamp's splitting).
CLEAVE_FN float divisionResidual(float a, float b, float q) {
    precise float p = q * b;
    precise float tq = 4097.0f * q;
    precise float qh = tq - q;
    qh = tq - qh;
    precise float ql = q - qh;
    precise float tb = 4097.0f * b;
    precise float bh = tb - b;
    bh = tb - bh;
    precise float bl = b - bh;
    precise float e0 = qh * bh;
    e0 = e0 - p;
    precise float e1 = qh * bl;
    precise float e2 = ql * bh;
    precise float e3 = ql * bl;
    precise float err = e0 + e1;
    err = err + e2;
    err = err + e3;
    precise float r = a - p;
    return r - err;
}

// a / b rounded to nearest, from a quotient that is off by a few ulp. For 0 <= a <= b and a above
// 2^-78 (below, the residual underflows on devices that flush denormals; clipping stays safe, by its margin).
CLEAVE_FN float correctedQuotient(float a, float b, float quotient) {
    precise float q = quotient;
    if (q == 0.0f) return 0.0f;
    precise float r = divisionResidual(a, b, q);
    // Surely nearest if off by less than half a step. Below a power of two the steps are half as wide: corrected below.
    uint bits = floatBitsToUint(q);
    precise float step = uintBitsToFloat(bits & 0x7F800000u) * 1.1920928955078125e-07f;
    precise float halfStep = 0.4999f * step * b;
    if (abs(r) < halfStep && ((bits & 0x007FFFFFu) != 0u || r >= 0.0f)) return q;
    precise float correction = r / b;
    q = q + correction;
    r = divisionResidual(a, b, q);
    float neighbour = nextFloat(q, r > 0.0f);
    precise float rn = divisionResidual(a, b, neighbour);
    return abs(rn) < abs(r) ? neighbour : q;
}

CLEAVE_FN float divRounded(float a, float b) {
#ifdef __cplusplus
    if (a > 0x1p-78f) return a / b;  // IEEE division, which the correction would only confirm
#endif
    return correctedQuotient(a, b, a / b);
}

CLEAVE_END
#endif
