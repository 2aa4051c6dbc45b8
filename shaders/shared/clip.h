// The boxes of the parts of a triangle on either side of a plane (split clipping, Havran and Bittner 2002), rounded so
// that they never lose a point.
//
// Sutherland and Hodgman's polygon clipping, always from the original triangle. Coordinates are relative to the first
// vertex, so that errors scale with the triangle and not with its distance from the origin. With E the largest |vertex
// - first vertex| and u = 2^-24, a cut places its vertices within 11 u E of the polygon it cuts (difference u, quotient
// 3 u, product u, each of at most 2 E; sum u), six cuts within 66 u E. So clipping against the cell widened by
// 2^-17 E = 128 u E loses no part of the triangle that meets the cell, not even if rounding bends the polygon so that
// it is not quite convex; and widening the result by as much makes its box hold that part.
#ifndef CLEAVE_SHARED_CLIP_H
#define CLEAVE_SHARED_CLIP_H
#include "box.h"
#include "div_rounded.h"
#include "triangle.h"

CLEAVE_BEGIN

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

// The larger box that also holds the points of an edge from `from` to `to` that have x[axis] <= position (below) or
// >= position (above): its start, if that is such a point, and where it crosses the plane.
CLEAVE_FN Box includingEdge(Box b, vec3 from, vec3 to, uint axis, float position, bool below) {
    bool fromIn = below ? from[axis] <= position : from[axis] >= position;
    bool toIn = below ? to[axis] <= position : to[axis] >= position;
    if (fromIn) b = including(b, from);
    // From the inside out, whatever the direction of travel: neighbours cut a shared edge alike.
    if (fromIn != toIn) {
        vec3 inside = fromIn ? from : to;
        vec3 outside = fromIn ? to : from;
        b = including(b, cutEdge(inside, outside, axis, position));
    }
    return b;
}

// From coordinates relative to `origin`, widened by `margin` and rounded outward, to a box within `cell` and `bounds`.
CLEAVE_FN Box placedBox(Box b, vec3 origin, float margin, Box cell, Box bounds) {
    if (isEmpty(b)) return emptyBox();
    for (uint axis = 0u; axis < 3u; axis++) {
        precise float lo = b.lo[axis] - margin;
        precise float hi = b.hi[axis] + margin;
        b.lo[axis] = nextFloat(lo + origin[axis], false);
        b.hi[axis] = nextFloat(hi + origin[axis], true);
    }
    b = intersection(intersection(b, cell), bounds);
    return isEmpty(b) ? emptyBox() : b;
}

// The boxes of what of a triangle lies in `box` (the box of its part in a cell) on either side of a plane through it.
struct SplitBoxes {
    Box left;
    Box right;
};

CLEAVE_FN SplitBoxes splitBoxes(Triangle t, Box box, uint splitAxis, float split) {
    // Two polygons of up to 9 vertices (a triangle cut by six planes): the one that is cut, and the result.
    vec3 at[18];
    uint now = 0u;
    uint count = 3u;
    at[0] = vec3(0.0f);
    at[1] = t.b - t.a;
    at[2] = t.c - t.a;
    float extent = max(largestComponent(at[1]), largestComponent(at[2]));
    precise float margin = 7.62939453125e-06f * extent + kSmallestNormal;
    Box bounds = triangleBox(t);
    for (uint plane = 0u; plane < 6u; plane++) {
        uint axis = plane >> 1;
        bool below = (plane & 1u) != 0u;
        if (below ? bounds.hi[axis] <= box.hi[axis] : bounds.lo[axis] >= box.lo[axis]) continue;
        precise float position = (below ? box.hi[axis] : box.lo[axis]) - t.a[axis];
        position = below ? position + margin : position - margin;
        uint inside = 0u;
        for (uint i = 0u; i < count; i++) {
            float x = at[now + i][axis];
            if (below ? x <= position : x >= position) inside |= 1u << i;
        }
        uint all = (1u << count) - 1u;
        if (inside == all) continue;
        if (inside == 0u) {
            count = 0u;
            break;
        }
        // The inside vertices of a convex polygon follow each other: they, then the two cuts, are the new polygon.
        uint starts = inside & ~((inside << 1 | inside >> (count - 1u)) & all);
        uint first = lowestBit(starts);
        uint from = first;
        uint last = first;
        uint next = 9u - now;
        uint n = 0u;
        while ((inside >> from & 1u) != 0u) {
            at[next + n] = at[now + from];
            n++;
            last = from;
            from = from + 1u < count ? from + 1u : 0u;
        }
        uint before = first > 0u ? first - 1u : count - 1u;
        at[next + n] = cutEdge(at[now + last], at[now + from], axis, position);
        at[next + n + 1u] = cutEdge(at[now + first], at[now + before], axis, position);
        count = n + 2u;
        now = next;
    }
    precise float position = split - t.a[splitAxis];
    Box l = emptyBox();
    Box r = emptyBox();
    for (uint i = 0u; i < count; i++) {
        vec3 from = at[now + i];
        vec3 to = at[now + (i + 1u < count ? i + 1u : 0u)];
        l = includingEdge(l, from, to, splitAxis, position + margin, true);
        r = includingEdge(r, from, to, splitAxis, position - margin, false);
    }
    SplitBoxes s;
    s.left = placedBox(l, t.a, margin, leftOf(box, splitAxis, split), bounds);
    s.right = placedBox(r, t.a, margin, rightOf(box, splitAxis, split), bounds);
    return s;
}

CLEAVE_END
#endif
