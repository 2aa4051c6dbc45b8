// How far a ray's origin is from a triangle's plane, with the exact sign: whether a ray that starts on a surface meets
// it at t = 0, just ahead or just behind must not depend on rounding.
#ifndef CLEAVE_SHARED_EXACT_HEIGHT_H
#define CLEAVE_SHARED_EXACT_HEIGHT_H
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

CLEAVE_FN double largestMagnitude(dvec3 v) {
    double xy = abs(v.x) < abs(v.y) ? abs(v.y) : abs(v.x);
    return xy < abs(v.z) ? abs(v.z) : xy;
}

// Sums of |v| |w| as the components of their cross product have them: what its rounding errors are measured by.
CLEAVE_FN dvec3 crossMagnitude(dvec3 v, dvec3 w) {
    return dvec3(abs(v.y * w.z) + abs(v.z * w.y), abs(v.z * w.x) + abs(v.x * w.z), abs(v.x * w.y) + abs(v.y * w.x));
}

// Of a scaled triangle and an origin within 4 of zero: more parts are never needed (see exactHeight).
CLEAVE_CONST uint kHeightParts = 10u;
CLEAVE_CONST float kHeightReach = 4.0f;

// det(a - o, b - o, c - o) = det(a, b, c) + det(o, c, b) + det(o, a, c) + det(o, b, a), in 24 products of three floats,
// each of which is exactly two doubles. Every one of these is added to the first part, what its rounding leaves over to
// the second, and so on (the cascade of Ogita, Rump and Oishi 2005). All of them are multiples of 2^-447 and their sum
// is below 2^7, so that nothing is left over after ten parts: each leaves 2^-53 of its sums, of at most 48 terms. The
// parts are then made an expansion (Shewchuk 1997, GROW-EXPANSION), whose largest one that is not 0 has the sign.
CLEAVE_FN double exactHeight(dvec3 o, dvec3 a, dvec3 b, dvec3 c) {
    double parts[kHeightParts];
    for (uint i = 0u; i < kHeightParts; i++) parts[i] = double(0.0f);
    for (uint n = 0u; n < 24u; n++) {
        uint which = n / 6u;
        dvec3 p = which == 0u ? a : o;
        dvec3 q = which == 0u ? b : which == 1u ? c : which == 2u ? a : b;
        dvec3 r = which == 0u ? c : which == 1u ? b : which == 2u ? c : a;
        uint i = n % 3u;
        uint j = i < 2u ? i + 1u : 0u;
        uint k = i > 0u ? i - 1u : 2u;
        bool isMinus = n / 3u % 2u == 1u;
        precise double two = isMinus ? -(q[k] * r[j]) : q[j] * r[k];
        precise double three = p[i] * two;
        double low = productRest(p[i], two, three);
        for (uint term = 0u; term < 2u; term++) {
            precise double x = term == 0u ? three : low;
            for (uint m = 0u; m < kHeightParts; m++) {
                precise double sum = parts[m] + x;
                precise double taken = sum - parts[m];
                precise double rest = (parts[m] - (sum - taken)) + (x - taken);
                parts[m] = sum;
                x = rest;
            }
        }
    }
    double grown[kHeightParts];
    for (uint i = 0u; i < kHeightParts; i++) {
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
    precise double height = grown[0];
    for (uint i = 1u; i < kHeightParts; i++) height = height + grown[i];
    return height;
}

// The same, where `height` was computed in double from the edges at a and the vertex at `from` the origin: that value
// if its sign is certain. Its error is at most 8 u = 2^-50 of the sum of its terms' magnitudes: 2 u from differences,
// a product and a sum in each component of the normal, the difference to the vertex, a product and two sums. Origins
// farther away than kHeightReach lie in no scaled triangle. Where all terms are 0 there is nothing to round.
CLEAVE_FN double certainHeight(double height, dvec3 from, dvec3 o, dvec3 a, dvec3 b, dvec3 c) {
    dvec3 e1 = b - a;
    dvec3 e2 = c - a;
    double size = largestMagnitude(e1) * largestMagnitude(e2) * largestMagnitude(from);
    if (abs(height) > double(1.4210854715202004e-14f) * size) return height;  // 2^-46: six terms, cheaply bounded
    dvec3 terms = crossMagnitude(e1, e2) * dvec3(abs(from.x), abs(from.y), abs(from.z));
    double magnitude = terms.x + terms.y + terms.z;
    bool isCertain = abs(height) > double(1.7763568394002505e-15f) * magnitude || magnitude == double(0.0f);
    if (isCertain || largestMagnitude(o) > double(kHeightReach)) return height;
    return exactHeight(o, a, b, c);
}

CLEAVE_END
#endif
