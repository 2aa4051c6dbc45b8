// The rule "once": a ray that passes through an edge or a vertex of a closed surface crosses exactly one of the
// triangles around it, or as many as enter and leave there. The rule of triangle.h, where an edge belongs to both its
// triangles, suits closest hits; this one suits counts.
//
// The line is moved by (e, e^2) in the sheared plane of triangle.h, with an e smaller than anything there is. So it
// passes no edge and no vertex: where the determinant of an edge is 0, its next coefficient in e decides, then the one
// of e^2; where all are 0 the edge is a point in that plane, and its triangle is seen edge-on, which the moved line
// misses. All signs are exact, so that the answer is that of geometry on the vertices as they are: the moved line
// crosses a closed surface an even number of times, and enters as often as it leaves where faces are oriented alike
// (docs/queries.md). Triangles of no area are never crossed, and may be left out.
#ifndef CLEAVE_SHARED_CROSSING_H
#define CLEAVE_SHARED_CROSSING_H
#include "triangle.h"

CLEAVE_BEGIN

// Whether a line crosses a triangle, and where.
struct Crossing {
    int side;  // 0: it does not. 1: in the direction of the normal (b - a) x (c - a), so that it leaves; -1: it enters
    float t;   // to a rounding of float, and negative only if exactly so
    float u;
    float v;
};

CLEAVE_FN Crossing noCrossing() {
    Crossing c;
    c.side = 0;
    c.t = infinity();
    c.u = 0.0f;
    c.v = 0.0f;
    return c;
}

CLEAVE_FN double largestComponent(dvec3 v) {
    double x = abs(v.x) > abs(v.y) ? abs(v.x) : abs(v.y);
    return abs(v.z) > x ? abs(v.z) : x;
}

CLEAVE_FN vec3 unitVector(uint axis) {
    vec3 v = vec3(0.0f);
    v[axis] = 1.0f;
    return v;
}

// Whether the sign of a.x b.y - a.y b.x, of vertices that shearedAlong() found, is that of the exact determinant. Its
// error per component is at most 2^-52 of that and 2^-102 of its terms, which are at most 2 `reach`.
CLEAVE_FN bool isSideCertain(dvec3 a, dvec3 b, double reach) {
    precise double xy = a.x * b.y;
    precise double yx = a.y * b.x;
    precise double side = xy - yx;
    double largest = abs(a.x) + abs(a.y) + abs(b.x) + abs(b.y);
    return abs(side) > powerOfTwo(-49) * (abs(xy) + abs(yx)) + powerOfTwo(-95) * reach * largest;
}

// Five determinants: three of the edges, then two whose quotient is t. Each is taken in double where that decides it,
// else exactly. They go through one loop, so that the exact part is compiled once.
CLEAVE_FN Crossing crossTriangle(vec3 origin, vec3 direction, vec3 va, vec3 vb, vec3 vc) {
    dvec3 o = dvec3(origin);
    dvec3 d = dvec3(direction);
    uint k = abs(direction.x) >= abs(direction.y) ? 0u : 1u;
    if (abs(direction.z) > abs(direction[k])) k = 2u;
    double reach = double(
        max(largestComponent(origin), max(largestComponent(va), max(largestComponent(vb), largestComponent(vc)))));
    vec3 vertices[3];
    vertices[0] = va;
    vertices[1] = vb;
    vertices[2] = vc;
    dvec3 sheared[3];
    for (uint i = 0u; i < 3u; i++) sheared[i] = shearedAlong(o, d, k, dvec3(vertices[i]));
    // The error of the slope is at most 84 u E^2 and that of the height 48 u E^2 H, with u = 2^-53, the largest edge E
    // and the way H to the nearest vertex. Where these are above 2^-20 E^2 and 2^-20 E^2 H, t is right.
    dvec3 ab = dvec3(vb) - dvec3(va);
    dvec3 ac = dvec3(vc) - dvec3(va);
    dvec3 n = preciseCross(ab, ac);
    dvec3 way = shorterOf(shorterOf(dvec3(va) - o, dvec3(vb) - o), dvec3(vc) - o);
    double edge = largestComponent(ab) + largestComponent(ac);
    double found[5];
    found[3] = preciseDot(n, d);
    found[4] = preciseDot(n, way);
    int side = 0;
    for (uint i = 0u; i < 5u; i++) {
        vec3 from = vertices[(i + 1u) % 3u];
        vec3 to = vertices[(i + 2u) % 3u];
        vec3 x = i == 4u ? va : direction;
        vec3 p = i < 3u ? from : vb;
        vec3 q = i < 3u ? to : vc;
        bool qIsPoint = true;
        vec3 base = i == 3u ? va : origin;
        bool certain;
        if (i < 3u) {
            found[i] = edgeSide(sheared[(i + 1u) % 3u], sheared[(i + 2u) % 3u]);
            certain = isSideCertain(sheared[(i + 1u) % 3u], sheared[(i + 2u) % 3u], reach);
        } else {
            double scale = powerOfTwo(-20) * edge * edge;
            if (i == 4u) scale = scale * largestComponent(way);
            certain = abs(found[i]) > scale;
        }
        for (uint next = 0u; next < 3u; next++) {
            double value = found[i];
            if (!certain) {
                value = exactDeterminant(x, i == 4u, p, q, qIsPoint, base);
                if (i < 3u && next == 0u) value = value * d[k];
                if (next == 0u) found[i] = value;
            }
            if (i >= 3u) break;
            if (value == 0.0) {
                // The coefficients of e and of e^2 are -((b - a) x d)[k + 1] and -((b - a) x d)[k + 2].
                if (next == 2u) return noCrossing();
                x = unitVector((k + 1u + next) % 3u);
                p = from;
                q = direction;
                qIsPoint = false;
                base = to;
                continue;
            }
            int sign = value > 0.0 ? 1 : -1;
            if (side == -sign) return noCrossing();
            side = sign;
            break;
        }
    }
    double sum = found[0] + found[1];
    sum = sum + found[2];
    double t = found[4] / found[3];
    Crossing c;
    c.side = d[k] > 0.0 ? side : -side;
    c.t = float(t);
    if (abs(t) < double(kSmallestNormal)) c.t = t < 0.0 ? -kSmallestNormal : 0.0f;
    c.u = float(found[1] / sum);
    c.v = float(found[2] / sum);
    return c;
}

CLEAVE_END
#endif
