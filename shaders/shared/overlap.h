// Whether a triangle meets a box, with the boundaries of both: exactly.
#ifndef CLEAVE_SHARED_OVERLAP_H
#define CLEAVE_SHARED_OVERLAP_H
#include "crossing.h"

CLEAVE_BEGIN

// The sign of det(x, p - o, q - o), or of det(x - o, p - o, q - o) where xIsPoint. The filter is that of Shewchuk's
// ORIENT3D (1997, section 4.3), with its bound doubled.
CLEAVE_FN int determinantSign(vec3 x, bool xIsPoint, vec3 p, vec3 q, vec3 o) {
    dvec3 s = dvec3(x);
    if (xIsPoint) s = s - dvec3(o);
    dvec3 a = dvec3(p) - dvec3(o);
    dvec3 b = dvec3(q) - dvec3(o);
    precise double value = 0.0;
    double magnitude = 0.0;
    for (uint i = 0u; i < 3u; i++) {
        uint j = (i + 1u) % 3u;
        uint k = (i + 2u) % 3u;
        precise double left = a[j] * b[k];
        precise double right = a[k] * b[j];
        precise double term = s[i] * (left - right);
        value = value + term;
        magnitude += abs(s[i]) * (abs(left) + abs(right));
    }
    if (abs(value) <= powerOfTwo(-49) * magnitude) value = exactDeterminant(x, xIsPoint, p, q, true, o);
    return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

CLEAVE_FN vec3 cornerOf(Box box, uint bits) {
    return vec3((bits & 1u) != 0u ? box.hi.x : box.lo.x, (bits & 2u) != 0u ? box.hi.y : box.lo.y,
                (bits & 4u) != 0u ? box.hi.z : box.lo.z);
}

// The separating axis test (Gottschalk et al. 1996; Akenine-Moeller 2001): they are apart iff they are strictly so
// along an axis, across an edge of the triangle seen along an axis, or across the triangle's plane. The triangle has an
// area; the box may be flat, or a point.
CLEAVE_FN bool meetsBox(Triangle t, Box box) {
    Box around = triangleBox(t);
    for (uint axis = 0u; axis < 3u; axis++)
        if (around.lo[axis] > box.hi[axis] || around.hi[axis] < box.lo[axis]) return false;
    vec3 vertices[3];
    vertices[0] = t.a;
    vertices[1] = t.b;
    vertices[2] = t.c;
    bool below = false;
    bool above = false;
    // Nine edges as seen along an axis, then the corners of the box, beside the triangle's plane.
    for (uint m = 0u; m < 17u; m++) {
        bool isEdge = m < 9u;
        vec3 a = vertices[isEdge ? m % 3u : 0u];
        vec3 b = vertices[isEdge ? (m + 1u) % 3u : 1u];
        vec3 c = vertices[isEdge ? (m + 2u) % 3u : 2u];
        uint axis = m / 3u;
        vec3 x = isEdge ? unitVector(axis) : cornerOf(box, m - 9u);
        int sign = determinantSign(x, !isEdge, b, c, a);
        if (isEdge && sign != 0) {
            // The corner that lies farthest to the side of the third vertex must lie on that side, or all are apart.
            uint i = (axis + 1u) % 3u;
            uint j = (axis + 2u) % 3u;
            vec3 corner = box.lo;
            corner[i] = (a[j] > b[j]) == (sign > 0) ? box.hi[i] : box.lo[i];
            corner[j] = (b[i] > a[i]) == (sign > 0) ? box.hi[j] : box.lo[j];
            if (determinantSign(x, false, b, corner, a) == -sign) return false;
        }
        below = below || (!isEdge && sign <= 0);
        above = above || (!isEdge && sign >= 0);
        if (below && above) return true;
    }
    return false;
}

CLEAVE_FN bool isBox(Box box) {
    for (uint axis = 0u; axis < 3u; axis++)
        if (isNan(box.lo[axis]) || isNan(box.hi[axis]) || box.lo[axis] > box.hi[axis]) return false;
    return true;
}

// A box of the world in a tree's space, cut to what its triangles, whose coordinates are below 1, can meet.
CLEAVE_FN Box scaledBox(Box box, int exponent) {
    Box s;
    s.lo = timesPowerOfTwo(box.lo, -exponent);
    s.hi = timesPowerOfTwo(box.hi, -exponent);
    for (uint axis = 0u; axis < 3u; axis++) {
        s.lo[axis] = min(max(s.lo[axis], -2.0f), 2.0f);
        s.hi[axis] = min(max(s.hi[axis], -2.0f), 2.0f);
    }
    return s;
}

CLEAVE_END
#endif
