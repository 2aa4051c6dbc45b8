// Roundings that devices are not bound to: quotients in double, for which Vulkan grants a few ulp, and floats below the
// smallest normal one, which devices may flush. Put right here, every device has the bits of IEEE arithmetic.
#ifndef CLEAVE_SHARED_ROUND_H
#define CLEAVE_SHARED_ROUND_H
#include "exact.h"

CLEAVE_BEGIN

// The bits of a double, the low word first.
#ifdef __cplusplus
inline uvec2 doubleBits(double x) {
    const auto bits = std::bit_cast<uint64_t>(x);
    return {static_cast<uint>(bits), static_cast<uint>(bits >> 32)};
}
inline double doubleOf(uvec2 bits) { return std::bit_cast<double>(uint64_t{bits.y} << 32 | bits.x); }
#else
uvec2 doubleBits(double x) { return unpackDouble2x32(x); }
double doubleOf(uvec2 bits) { return packDouble2x32(bits); }
#endif

// The next double above x, or below it; x is normal.
CLEAVE_FN double nextDouble(double x, bool up) {
    uvec2 bits = doubleBits(x);
    if (up == (x > double(0.0f))) {
        bits.x = bits.x + 1u;
        if (bits.x == 0u) bits.y = bits.y + 1u;
    } else {
        if (bits.x == 0u) bits.y = bits.y - 1u;
        bits.x = bits.x - 1u;
    }
    return doubleOf(bits);
}

// a - q b for a q within a few ulp of a / b.
CLEAVE_FN double quotientResidual(double a, double b, double q) {
    precise double product = q * b;
    precise double rest = a - product;
    rest = rest - productRest(q, b, product);
    return rest;
}

// a / b rounded to nearest, from a quotient that is off by a few ulp; b is above 0. What is so large or so small that
// the residual would overflow or underflow stays as it is.
CLEAVE_FN double correctedQuotient(double a, double b, double quotient) {
    bool isFar = !(abs(a) > powerOfTwo(-600) && abs(a) < powerOfTwo(600));
    if (isFar || !(b > powerOfTwo(-200) && b < powerOfTwo(200))) return quotient;
    precise double correction = quotientResidual(a, b, quotient) / b;
    precise double q = quotient + correction;  // off by an ulp at most
    double residual = quotientResidual(a, b, q);
    double neighbour = nextDouble(q, residual > double(0.0f));
    double other = quotientResidual(a, b, neighbour);
    return abs(other) < abs(residual) ? neighbour : q;
}

// The bits of a double rounded to the nearest float, ties to even.
CLEAVE_FN uint roundedBits(double x) {
    if (!(abs(x) < double(kSmallestNormal))) return floatBitsToUint(float(x));
    precise double steps = abs(x) * powerOfTwo(149);  // of the smallest float; exact
    precise double whole = steps + powerOfTwo(52);    // whose last place is 1
    return doubleBits(whole).x | (doubleBits(x).y & 0x80000000u);
}

CLEAVE_END
#endif
