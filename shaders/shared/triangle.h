// Ray-triangle intersection: watertight, edge-inclusive, two-sided.
//
// Which side of an edge a ray passes is the sign of a determinant. A float filter (the terms of Moeller and Trumbore
// 1997, with a bound on their error) rejects clear misses; everything else is decided in double, on the vertices as
// they are, in a plane perpendicular to the ray (Woop, Benthin and Wald 2013). Each vertex is projected independently
// of the others, so all triangles that share it see it in the same place, and the sign of an edge is that of the exact
// determinant of two projected vertices. A sign of 0 counts as inside, so no ray slips through an edge or a vertex.
// (d . (A x B) in double is antisymmetric as well, but its rounding can leave signs around a vertex that no triangle
// accepts.) t is accurate to a rounding of float. The filter only rejects, so it cannot contradict the exact part.
#ifndef CLEAVE_SHARED_TRIANGLE_H
#define CLEAVE_SHARED_TRIANGLE_H
#include "box.h"
#include "exact_height.h"
#include "ray.h"

CLEAVE_BEGIN

// Triangle tests to choose from: the watertight one; Moeller and Trumbore's in float, which is quick and leaks; and the
// watertight one without its filter in float.
CLEAVE_CONST uint kWatertightTest = 0u;
CLEAVE_CONST uint kPlainTest = 1u;
CLEAVE_CONST uint kUnfilteredTest = 2u;

struct Triangle {
    vec3 a;
    vec3 b;
    vec3 c;
};
CLEAVE_SIZE(Triangle, 36);

CLEAVE_FN Box triangleBox(Triangle t) {
    Box b;
    b.lo = vec3(min(t.a.x, min(t.b.x, t.c.x)), min(t.a.y, min(t.b.y, t.c.y)), min(t.a.z, min(t.b.z, t.c.z)));
    b.hi = vec3(max(t.a.x, max(t.b.x, t.c.x)), max(t.a.y, max(t.b.y, t.c.y)), max(t.a.z, max(t.b.z, t.c.z)));
    return b;
}

CLEAVE_FN float largestComponent(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// Rounds each product, since a contracted a*b - c*d would not be antisymmetric.
CLEAVE_FN vec3 preciseCross(vec3 a, vec3 b) {
    precise float x0 = a.y * b.z;
    precise float x1 = a.z * b.y;
    precise float y0 = a.z * b.x;
    precise float y1 = a.x * b.z;
    precise float z0 = a.x * b.y;
    precise float z1 = a.y * b.x;
    return vec3(x0 - x1, y0 - y1, z0 - z1);
}
CLEAVE_FN float preciseDot(vec3 a, vec3 b) {
    precise float x = a.x * b.x;
    precise float y = a.y * b.y;
    precise float z = a.z * b.z;
    precise float s = x + y;
    return s + z;
}
CLEAVE_FN dvec3 preciseCross(dvec3 a, dvec3 b) {
    precise double x0 = a.y * b.z;
    precise double x1 = a.z * b.y;
    precise double y0 = a.z * b.x;
    precise double y1 = a.x * b.z;
    precise double z0 = a.x * b.y;
    precise double z1 = a.y * b.x;
    return dvec3(x0 - x1, y0 - y1, z0 - z1);
}
CLEAVE_FN double preciseDot(dvec3 a, dvec3 b) {
    precise double x = a.x * b.x;
    precise double y = a.y * b.y;
    precise double z = a.z * b.z;
    precise double s = x + y;
    return s + z;
}

// What float arithmetic knows of a line and a triangle: whether it certainly misses, whether it certainly hits, and if
// it hits, an interval that holds the t of resolveTriangle().
struct FilteredHit {
    bool misses;
    bool hits;
    float tLow;  // -inf to inf where nothing is known
    float tHigh;
};

// Beyond this distance from the ray's origin nothing is said of t.
CLEAVE_CONST float kFilterReach = 1.0e12f;

// The terms of Moeller and Trumbore (1997), each with a bound of its error. With |d| < 2 per component, E the largest
// edge, A the largest |a - origin| component and u = 2^-24, the largest error of one rounding relative to its result:
// - u and v err by at most 84 u A E, w = det - u - v by 108 u E (2 A + E). 2^-17 E (2 A + E) covers all three.
//   resolveTriangle() decides by the same three determinants in double, whose errors vanish in what is left over.
// - det errs by at most 84 u E^2, and n, so that t = n / det, by 48 u A E^2. Where |det| > 2^-15 E^2, the quotient errs
//   by at most (48 u A + 84 u |t|) E^2 / |det|, where |t| may itself be larger by a half: 2^-17 (A + 2 |t|) E^2 / |det|
//   covers it, and 2^-20 |t| covers the division, the bound's own rounding and that of t to float.
// Absolute terms cover what falls below the smallest normal number.
CLEAVE_FN FilteredHit filterTriangle(vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c) {
    vec3 e1 = b - a;
    vec3 e2 = c - a;
    vec3 s = origin - a;
    vec3 p = preciseCross(direction, e2);
    vec3 q = preciseCross(s, e1);
    precise float det = preciseDot(e1, p);
    precise float u = preciseDot(s, p);
    precise float v = preciseDot(direction, q);
    precise float w = det - u;
    w = w - v;
    float edge = max(largestComponent(e1), largestComponent(e2));
    float reach = largestComponent(s);
    precise float bound = 7.62939453125e-06f * edge * (2.0f * reach + edge) + 1.0e-36f;
    float least = min(u, min(v, w));
    float most = max(u, max(v, w));
    float size = abs(det);
    bool knowsT = reach < kFilterReach && size > 3.0517578125e-05f * edge * edge + 1.0e-30f;
    float inverse = 1.0f / size;
    float n = preciseDot(e2, q);
    float distance = abs(n) * inverse;
    float t = (n < 0.0f) == (det < 0.0f) ? distance : -distance;
    float slack =
        inverse * (7.62939453125e-06f * edge * edge * (reach + 2.0f * distance) + 1.0e-36f * (1.0f + distance)) +
        9.5367431640625e-07f * distance;
    FilteredHit f;
    f.misses = least < -bound && most > bound;
    f.hits = knowsT && (least > bound || most < -bound);
    f.tLow = knowsT ? t - slack : -infinity();
    f.tHigh = knowsT ? t + slack : infinity();
    return f;
}

// Returns (a - b) - (c - d) to within a rounding of double, even where nearly all of it cancels: Knuth's two-sum keeps
// the rounding error of each difference.
CLEAVE_FN double differenceOfDifferences(double a, double b, double c, double d) {
    precise double ab = a - b;
    precise double abPart = ab - a;
    precise double abRest = (a - (ab - abPart)) - (b + abPart);
    precise double cd = c - d;
    precise double cdPart = cd - c;
    precise double cdRest = (c - (cd - cdPart)) - (d + cdPart);
    precise double sum = ab - cd;
    precise double sumPart = sum - ab;
    precise double sumRest = (ab - (sum - sumPart)) - (cd + sumPart);
    precise double rest = sumRest + (abRest - cdRest);
    return sum + rest;
}

// Projects a vertex along the ray, times d[k]: Woop's shear (2013, section 3.1) without its division. Products of
// floats are exact in double, so the error is a rounding of the result, not of the distance from the origin: rays from
// far away hit tiny triangles as accurately as rays from nearby.
CLEAVE_FN dvec3 shearedAlong(dvec3 o, dvec3 d, uint k, dvec3 v) {
    uint i = k < 2u ? k + 1u : 0u;
    uint j = k > 0u ? k - 1u : 2u;
    return dvec3(differenceOfDifferences(v[i] * d[k], v[k] * d[i], o[i] * d[k], o[k] * d[i]),
                 differenceOfDifferences(v[j] * d[k], v[k] * d[j], o[j] * d[k], o[k] * d[j]), 0.0);
}

// Tells on which side of the edge from a to b the ray passes, with the exact sign. Rounding is monotone, so a
// difference of rounded products has the exact sign or is 0; if it is 0, the rounding errors decide. (Otherwise all
// edges of a triangle 2^53 times smaller than its distance from the ray would come out as 0, and it would always be
// hit.)
CLEAVE_FN double edgeSide(dvec3 a, dvec3 b) {
    precise double xy = a.x * b.y;
    precise double yx = a.y * b.x;
    precise double side = xy - yx;
    if (side != 0.0) return side;
    return productRest(a.x, b.y, xy) - productRest(a.y, b.x, yx);
}

CLEAVE_FN dvec3 shorterOf(dvec3 v, dvec3 w) { return preciseDot(w, w) < preciseDot(v, v) ? w : v; }

// The exact part of the watertight test: signs decide between hit and miss, then t, u and v are computed. Distances
// |v - origin| up to 1e70 do not overflow.
CLEAVE_FN Hit resolveTriangle(vec3 origin, vec3 direction, vec3 va, vec3 vb, vec3 vc) {
    Hit h = missedHit();
    dvec3 o = dvec3(origin);
    dvec3 d = dvec3(direction);
    dvec3 a = dvec3(va) - o;
    dvec3 b = dvec3(vb) - o;
    dvec3 c = dvec3(vc) - o;
    uint k = abs(direction.x) >= abs(direction.y) ? 0u : 1u;
    if (abs(direction.z) > abs(direction[k])) k = 2u;
    dvec3 sa = shearedAlong(o, d, k, dvec3(va));
    dvec3 sb = shearedAlong(o, d, k, dvec3(vb));
    dvec3 sc = shearedAlong(o, d, k, dvec3(vc));
    double wa = edgeSide(sb, sc);
    double wb = edgeSide(sc, sa);
    double wc = edgeSide(sa, sb);
    bool negative = wa < 0.0 || wb < 0.0 || wc < 0.0;
    bool positive = wa > 0.0 || wb > 0.0 || wc > 0.0;
    if (negative == positive) return h;  // outside an edge, or the ray lies in the triangle's plane
    dvec3 n = preciseCross(dvec3(vb) - dvec3(va), dvec3(vc) - dvec3(va));
    precise double slope = preciseDot(n, d);
    // Measured from the nearest vertex: the error shrinks with its distance.
    dvec3 from = shorterOf(shorterOf(a, b), c);
    precise double height = preciseDot(n, from);
    height = certainHeight(height, from, origin, va, vb, vc);
    precise double sum = wa + wb;
    sum = sum + wc;
    if (slope == 0.0) return h;
    precise double t = height / slope;
    h.t = float(t);
    if (t < 0.0 && h.t > -kSmallestNormal) h.t = -kSmallestNormal;  // behind the origin is not at it
    h.u = float(wb / sum);
    h.v = float(wc / sum);
    return h;
}

// Intersects the line of the ray with the triangle. The caller compares t with the interval of the ray, and sets
// `prim`.
CLEAVE_FN Hit intersectTriangle(vec3 origin, vec3 direction, Triangle triangle) {
    if (filterTriangle(origin, direction, triangle.a, triangle.b, triangle.c).misses) return missedHit();
    return resolveTriangle(origin, direction, triangle.a, triangle.b, triangle.c);
}

// Moeller and Trumbore's test (1997) in float, edge-inclusive, to compare with. Rays slip between triangles where
// rounding puts them outside both, and t is only as accurate as float and cancellation allow.
CLEAVE_FN Hit plainTriangle(vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c) {
    Hit h = missedHit();
    vec3 e1 = b - a;
    vec3 e2 = c - a;
    vec3 s = origin - a;
    vec3 p = preciseCross(direction, e2);
    vec3 q = preciseCross(s, e1);
    float det = preciseDot(e1, p);
    if (det == 0.0f) return h;
    float inverse = 1.0f / det;
    float u = preciseDot(s, p) * inverse;
    float v = preciseDot(direction, q) * inverse;
    if (u < 0.0f || v < 0.0f || u + v > 1.0f) return h;
    h.t = preciseDot(e2, q) * inverse;
    h.u = u;
    h.v = v;
    return h;
}

// Orders hits by t, then by triangle number, so that answers do not depend on the order of tests.
CLEAVE_FN bool isCloser(Hit a, Hit b) { return a.t < b.t || (a.t == b.t && a.prim < b.prim); }

CLEAVE_END
#endif
