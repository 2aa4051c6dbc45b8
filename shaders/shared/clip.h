// The box of the part of a triangle that lies in a cell (split clipping, Havran and Bittner 2002), rounded so that it
// never loses a point.
//
// Sutherland and Hodgman's polygon clipping, always from the original triangle. Coordinates are relative to the first
// vertex, so that errors scale with the triangle and not with its distance from the origin. With E the largest |vertex
// - first vertex| and u = 2^-24, a cut places its vertex within 11 u E of the polygon it cuts (difference u, quotient 3
// u, product u, each of at most 2 E; sum u), six cuts within 66 u E. So clipping against the cell widened by 2^-17 E =
// 128 u E loses no part of the triangle that meets the cell, and widening the result by as much makes its box hold that
// part.
#ifndef CLEAVE_SHARED_CLIP_H
#define CLEAVE_SHARED_CLIP_H
#include "box.h"
#include "div_rounded.h"
#include "triangle.h"

CLEAVE_BEGIN

CLEAVE_CONST uint kMaxPolygon = 9u;  // a triangle cut by six planes

struct Polygon {
    vec3 at[9];
    uint count;
};

// Where the edge from `inside` to `outside` meets x[axis] = position; that coordinate is set exactly.
CLEAVE_FN vec3 cutEdge(vec3 inside, vec3 outside, uint axis, float position) {
    vec3 e = outside - inside;
    float t = divRounded(abs(position - inside[axis]), abs(e[axis]));
    precise float x = t * e.x;
    precise float y = t * e.y;
    precise float z = t * e.z;
    vec3 p = vec3(inside.x + x, inside.y + y, inside.z + z);
    p[axis] = position;
    return p;
}

// The part of the polygon with x[axis] >= position (keepAbove) or <= position.
CLEAVE_FN Polygon cutPolygon(Polygon p, uint axis, float position, bool keepAbove) {
    Polygon r;
    r.count = 0u;
    for (uint i = 0u; i < p.count; i++) {
        vec3 from = p.at[i];
        vec3 to = p.at[i + 1u < p.count ? i + 1u : 0u];
        bool fromIn = keepAbove ? from[axis] >= position : from[axis] <= position;
        bool toIn = keepAbove ? to[axis] >= position : to[axis] <= position;
        if (fromIn && r.count < kMaxPolygon) {
            r.at[r.count] = from;
            r.count++;
        }
        if (fromIn != toIn && r.count < kMaxPolygon) {
            // From the inside out, whatever the direction of travel: neighbours cut a shared edge alike.
            r.at[r.count] = fromIn ? cutEdge(from, to, axis, position) : cutEdge(to, from, axis, position);
            r.count++;
        }
    }
    return r;
}

CLEAVE_FN Box polygonBox(Polygon p) {
    Box b = emptyBox();
    for (uint i = 0u; i < p.count; i++) b = including(b, p.at[i]);
    return b;
}

// The box of triangle and cell's common part, within the cell; empty only if they have no point in common.
CLEAVE_FN Box clippedBox(Triangle t, Box cell) {
    Polygon p;
    p.at[0] = vec3(0.0f);
    p.at[1] = t.b - t.a;
    p.at[2] = t.c - t.a;
    p.count = 3u;
    float extent = max(largestComponent(p.at[1]), largestComponent(p.at[2]));
    precise float margin = 7.62939453125e-06f * extent + kSmallestNormal;
    for (uint axis = 0u; axis < 3u; axis++) {
        precise float lo = cell.lo[axis] - t.a[axis];
        lo = lo - margin;
        precise float hi = cell.hi[axis] - t.a[axis];
        hi = hi + margin;
        Box b = polygonBox(p);
        if (b.lo[axis] < lo) p = cutPolygon(p, axis, lo, true);
        if (b.hi[axis] > hi) p = cutPolygon(p, axis, hi, false);
    }
    if (p.count == 0u) return emptyBox();
    Box b = polygonBox(p);
    for (uint axis = 0u; axis < 3u; axis++) {
        precise float lo = b.lo[axis] - margin;
        precise float hi = b.hi[axis] + margin;
        b.lo[axis] = nextFloat(lo + t.a[axis], false);
        b.hi[axis] = nextFloat(hi + t.a[axis], true);
    }
    b = intersection(intersection(b, cell), triangleBox(t));
    return isEmpty(b) ? emptyBox() : b;
}

CLEAVE_END
#endif
