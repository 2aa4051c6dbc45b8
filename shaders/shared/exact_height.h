// How far a ray's origin is from a triangle's plane, with the exact sign: whether a ray that starts on a surface meets
// it at t = 0, just ahead or just behind must not depend on rounding.
#ifndef CLEAVE_SHARED_EXACT_HEIGHT_H
#define CLEAVE_SHARED_EXACT_HEIGHT_H
#include "exact.h"

CLEAVE_BEGIN

CLEAVE_FN double largestMagnitude(dvec3 v) {
    double xy = abs(v.x) < abs(v.y) ? abs(v.y) : abs(v.x);
    return xy < abs(v.z) ? abs(v.z) : xy;
}

// Sums of |v| |w| as the components of their cross product have them: what its rounding errors are measured by.
CLEAVE_FN dvec3 crossMagnitude(dvec3 v, dvec3 w) {
    return dvec3(abs(v.y * w.z) + abs(v.z * w.y), abs(v.z * w.x) + abs(v.x * w.z), abs(v.x * w.y) + abs(v.y * w.x));
}

CLEAVE_CONST float kHeightReach = 4.0f;

// det(a - o, b - o, c - o), where `height` is that determinant as computed in double from the edges at a and the vertex
// at `from` the origin: that value if its sign is certain, else the exact one. Its error is at most 8 u = 2^-50 of the
// sum of its terms' magnitudes: 2 u from differences, a product and a sum in each component of the normal, the
// difference to the vertex, a product and two sums. Origins farther away than kHeightReach lie in no scaled triangle.
// Where all terms are 0 there is nothing to round.
CLEAVE_FN double certainHeight(double height, dvec3 from, vec3 o, vec3 a, vec3 b, vec3 c) {
    dvec3 e1 = dvec3(b) - dvec3(a);
    dvec3 e2 = dvec3(c) - dvec3(a);
    double size = largestMagnitude(e1) * largestMagnitude(e2) * largestMagnitude(from);
    if (abs(height) > double(1.4210854715202004e-14f) * size) return height;  // 2^-46: six terms, cheaply bounded
    dvec3 terms = crossMagnitude(e1, e2) * dvec3(abs(from.x), abs(from.y), abs(from.z));
    double magnitude = terms.x + terms.y + terms.z;
    bool isCertain = abs(height) > double(1.7763568394002505e-15f) * magnitude || magnitude == double(0.0f);
    if (isCertain || largestMagnitude(dvec3(o)) > double(kHeightReach)) return height;
    return exactDeterminant(a, true, b, c, true, o);
}

CLEAVE_END
#endif
