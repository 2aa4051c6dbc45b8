// From vertices as users have them to the triangles of a tree: which are left out, and the power of two that scales
// them.
#ifndef CLEAVE_SHARED_GEOMETRY_H
#define CLEAVE_SHARED_GEOMETRY_H
#include "tree.h"

CLEAVE_BEGIN

// Part of the triangles of a scene; as Geometry in cleave/cleave.hpp.
struct GeometryData {
    CLEAVE_ADDRESS(FloatArray) vertices;
    CLEAVE_ADDRESS(UintArray) indices;
    CLEAVE_ADDRESS(FloatArray) transform;  // three rows of four, where hasTransform
    uint stride;                           // of vertices, in floats
    uint vertexCount;
    uint firstTriangle;  // number of its first triangle
    uint indexBits;      // 32, 16, or 0: without indices
    uint hasTransform;
    uint reserved;
};
CLEAVE_SIZE(GeometryData, 48);

// One row of an affine map, applied in double. Whatever places a vertex does it by this, in this order: a vertex is the
// same to the last bit wherever it is made.
CLEAVE_FN double transformedBy(double x, double y, double z, double w, dvec3 p) {
    precise double a = x * p.x;
    precise double b = y * p.y;
    precise double c = z * p.z;
    precise double sum = a + b;
    sum = sum + c;
    sum = sum + w;
    return sum;
}

CLEAVE_FN bool isFiniteTriangle(Triangle t) { return isFinite3(t.a) && isFinite3(t.b) && isFinite3(t.c); }

// Bits of the largest |coordinate| of a vertex; 0 if the vertex is not finite.
CLEAVE_FN uint reachOf(vec3 v) { return isFinite3(v) ? floatBitsToUint(largestComponent(v)) : 0u; }

// The scale of a tree: world = scaled 2^exponent, so that the largest scaled |coordinate| is in [0.5, 1). `largest` is
// the largest reachOf() of all vertices.
CLEAVE_FN int sceneExponent(uint largest) { return largest == 0u ? 0 : 1 + binaryExponent(uintBitsToFloat(largest)); }

CLEAVE_FN Triangle scaledTriangle(Triangle t, int n) {
    Triangle s;
    s.a = timesPowerOfTwo(t.a, n);
    s.b = timesPowerOfTwo(t.b, n);
    s.c = timesPowerOfTwo(t.c, n);
    return s;
}

// Tells whether a triangle has exactly no area, projected along one axis: whether (b - a) x (c - a) is 0 for the points
// (ax, ay), (bx, by), (cx, cy), which are floats of at most 1. Rounded differences decide nearly always (the bound is
// that of Shewchuk's ORIENT2D, 1997). Else the six products, each exact in double, are summed exactly: each is added to
// an expansion of six parts by TWO-SUMs (Shewchuk's GROW-EXPANSION), which is 0 only if all of its parts are.
CLEAVE_FN bool hasNoProjectedArea(double ax, double ay, double bx, double by, double cx, double cy) {
    precise double left = (bx - ax) * (cy - ay);
    precise double right = (by - ay) * (cx - ax);
    precise double difference = left - right;
    if (abs(difference) > double(3.5e-16f) * (abs(left) + abs(right))) return false;
    double products[6];
    products[0] = bx * cy;
    products[1] = -(bx * ay);
    products[2] = -(ax * cy);
    products[3] = -(by * cx);
    products[4] = by * ax;
    products[5] = ay * cx;
    double parts[6];
    for (uint i = 0u; i < 6u; i++) {
        precise double sum = products[i];
        for (uint k = 0u; k < i; k++) {
            precise double with = sum + parts[k];
            precise double taken = with - sum;
            precise double rest = (sum - (with - taken)) + (parts[k] - taken);
            parts[k] = rest;
            sum = with;
        }
        parts[i] = sum;
    }
    bool isZero = true;
    for (uint i = 0u; i < 6u; i++) isZero = isZero && parts[i] == double(0.0f);
    return isZero;
}

// A triangle whose vertices lie on a line has exactly no area, whichever way it is projected. Such a triangle is never
// hit and stays out of a tree.
CLEAVE_FN bool liesOnALine(Triangle t) {
    dvec3 a = dvec3(t.a);
    dvec3 b = dvec3(t.b);
    dvec3 c = dvec3(t.c);
    return hasNoProjectedArea(a.x, a.y, b.x, b.y, c.x, c.y) && hasNoProjectedArea(a.y, a.z, b.y, b.z, c.y, c.z) &&
           hasNoProjectedArea(a.z, a.x, b.z, b.x, c.z, c.x);
}

CLEAVE_END
#endif
