// The exact sign of determinants of floats, for decisions that must be right. Rare: callers come here where double
// leaves the sign open.
#ifndef CLEAVE_SHARED_EXACT_H
#define CLEAVE_SHARED_EXACT_H
#include "language.h"

CLEAVE_BEGIN

// Exact rounding error of a * b (Dekker's two-product, 1971, with Veltkamp's split at 27 bits); `product` is a * b,
// rounded.
CLEAVE_FN double productRest(double a, double b, double product) {
    precise double aBig = double(134217729u) * a;
    precise double aHigh = aBig - (aBig - a);
    precise double aLow = a - aHigh;
    precise double bBig = double(134217729u) * b;
    precise double bHigh = bBig - (bBig - b);
    precise double bLow = b - bHigh;
    precise double rest = ((aHigh * bHigh - product) + aHigh * bLow) + aLow * bHigh;
    rest = rest + aLow * bLow;
    return rest;
}

// A difference in each component, and whether it was not rounded.
struct Difference {
    dvec3 rounded;
    bool isExact;
};

CLEAVE_FN Difference differenceOf(vec3 a, vec3 b) {
    Difference d;
    d.rounded = dvec3(a) - dvec3(b);
    d.isExact = true;
    for (uint i = 0u; i < 3u; i++) {
        precise double whole = d.rounded[i];
        precise double part = whole - double(a[i]);
        precise double error = (double(a[i]) - (whole - part)) - (double(b[i]) + part);
        d.isExact = d.isExact && error == 0.0;
    }
    return d;
}

// Of determinants of floats of any size: more parts are never needed (see exactDeterminant).
CLEAVE_CONST uint kExactParts = 18u;

// det(x, a - o, b) with the exact sign and a relative error of at most 2^-51; where xIsPoint, x - o in place of x, and
// b - o in place of b where bIsPoint. Nearly always the differences are doubles; else multilinearity gives up to four
// determinants of the vectors as they are.
//
// Of each product of three, which up to four doubles hold exactly, each is added to the first part, what its rounding
// leaves over to the second, and so on (the cascade of Ogita, Rump and Oishi 2005). All of them are multiples of 2^-447
// and at most 48 are not 0, so that sums are below 2^393 and leave 2^-53 of that to the next part, at most 48 times:
// 2^-47.4 from part to part, and nothing after 18. The parts are then made an expansion (Shewchuk 1997,
// GROW-EXPANSION), whose largest one that is not 0 has the sign. Indices are constants once the loops over parts are
// unrolled: devices without indexed registers (lavapipe) keep them in registers all the same.
CLEAVE_FN double exactDeterminant(vec3 x, bool xIsPoint, vec3 a, vec3 b, bool bIsPoint, vec3 o) {
    Difference ao = differenceOf(a, o);
    Difference xo = differenceOf(x, xIsPoint ? o : vec3(0.0f));
    Difference bo = differenceOf(b, bIsPoint ? o : vec3(0.0f));
    bool isOne = ao.isExact && xo.isExact && bo.isExact;
    double parts[kExactParts];
    for (uint i = 0u; i < kExactParts; i++) parts[i] = double(0.0f);
    for (uint n = 0u; n < (isOne ? 6u : 24u); n++) {
        // det(x, a, b) - det(x, o, b) - det(x, a, o) - det(o, a, b), a product of three at a time.
        uint which = n / 6u;
        if ((which == 2u && !bIsPoint) || (which == 3u && !xIsPoint)) continue;
        dvec3 p = isOne ? xo.rounded : which == 3u ? dvec3(o) : dvec3(x);
        dvec3 q = isOne ? ao.rounded : which == 1u ? dvec3(o) : dvec3(a);
        dvec3 r = isOne ? bo.rounded : which == 2u ? dvec3(o) : dvec3(b);
        uint i = n % 3u;
        bool crossed = n % 6u >= 3u;
        uint j = (i + (crossed ? 2u : 1u)) % 3u;
        uint k = (i + (crossed ? 1u : 2u)) % 3u;
        double third = crossed != (which > 0u) ? -p[i] : p[i];
        precise double two = q[j] * r[k];
        double twoRest = productRest(q[j], r[k], two);
        precise double high = two * third;
        precise double low = twoRest * third;
        for (uint term = 0u; term < 4u; term++) {
            precise double rest = term == 0u   ? high
                                  : term == 1u ? productRest(two, third, high)
                                  : term == 2u ? low
                                               : productRest(twoRest, third, low);
            if (rest == 0.0) continue;
            for (uint m = 0u; m < kExactParts; m++) {
                precise double sum = parts[m] + rest;
                precise double taken = sum - parts[m];
                precise double left = (parts[m] - (sum - taken)) + (rest - taken);
                parts[m] = sum;
                rest = left;
            }
        }
    }
    double grown[kExactParts];
    for (uint i = 0u; i < kExactParts; i++) {
        precise double sum = parts[i];
        for (uint k = 0u; k < i; k++) {
            precise double both = sum + grown[k];
            precise double taken = both - sum;
            precise double rest = (sum - (both - taken)) + (grown[k] - taken);
            grown[k] = rest;
            sum = both;
        }
        grown[i] = sum;
    }
    precise double value = grown[0];
    for (uint i = 1u; i < kExactParts; i++) value = value + grown[i];
    return value;
}

CLEAVE_END
#endif
