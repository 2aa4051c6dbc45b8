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

// A convex polygon as its edges, in no order. Each cut adds at most one, in a place of its own, so that every index is
// known when a kernel is compiled: a GPU keeps arrays that are indexed otherwise in memory, and lavapipe reads and
// writes them lane by lane.
CLEAVE_CONST uint kMostEdges = 9u;  // a triangle, cut by six planes
struct EdgeSet {
    vec3 from[9];
    vec3 to[9];
    uint used;  // a bit for each edge that is there
};

// The edges that cross a plane: two, or none, of a convex polygon.
struct Crossings {
    vec3 inside0, outside0;
    vec3 inside1, outside1;
    uint first;  // index of the edge; kMostEdges if there is none
    uint last;   // the same one, if there is but one
};

CLEAVE_FN bool isWithin(vec3 p, uint axis, float position, bool below) {
    return below ? p[axis] <= position : p[axis] >= position;
}

CLEAVE_FN Crossings crossingsOf(EdgeSet edges, uint axis, float position, bool below) {
    Crossings c;
    c.inside0 = vec3(0.0f);
    c.outside0 = vec3(0.0f);
    c.inside1 = vec3(0.0f);
    c.outside1 = vec3(0.0f);
    c.first = kMostEdges;
    c.last = kMostEdges;
    CLEAVE_UNROLL for (uint i = 0u; i < kMostEdges; i++) {
        bool fromIn = isWithin(edges.from[i], axis, position, below);
        bool toIn = isWithin(edges.to[i], axis, position, below);
        if ((edges.used >> i & 1u) == 0u || fromIn == toIn) continue;
        // From the inside out, whatever the direction of travel: neighbours cut a shared edge alike.
        c.inside1 = fromIn ? edges.from[i] : edges.to[i];
        c.outside1 = fromIn ? edges.to[i] : edges.from[i];
        c.last = i;
        if (c.first == kMostEdges) {
            c.inside0 = c.inside1;
            c.outside0 = c.outside1;
            c.first = i;
        }
    }
    return c;
}

// Cuts off what lies beyond a plane; the new edge along the plane gets the place `added`. Where rounding has bent the
// polygon so that more than two edges cross, those between the first and the last stay whole, which loses nothing.
CLEAVE_FN EdgeSet cutAt(EdgeSet edges, uint axis, float position, bool below, uint added) {
    Crossings c = crossingsOf(edges, axis, position, below);
    bool crosses = c.first != kMostEdges;
    vec3 cut0 = vec3(0.0f);
    vec3 cut1 = vec3(0.0f);
    if (crosses) {
        cut0 = cutEdge(c.inside0, c.outside0, axis, position);
        cut1 = cutEdge(c.inside1, c.outside1, axis, position);
    }
    CLEAVE_UNROLL for (uint i = 0u; i < kMostEdges; i++) {
        bool fromIn = isWithin(edges.from[i], axis, position, below);
        bool toIn = isWithin(edges.to[i], axis, position, below);
        if (!fromIn && !toIn) edges.used &= ~(1u << i);
        if (i == c.first && !fromIn) edges.from[i] = cut0;
        if (i == c.first && !toIn) edges.to[i] = cut0;
        if (i == c.last && i != c.first && !fromIn) edges.from[i] = cut1;
        if (i == c.last && i != c.first && !toIn) edges.to[i] = cut1;
        if (i == added && crosses) {
            edges.from[i] = cut0;
            edges.to[i] = cut1;
            edges.used |= 1u << i;
        }
    }
    return edges;
}

// The box of the polygon's part on one side of a plane.
CLEAVE_FN Box boxWithin(EdgeSet edges, uint axis, float position, bool below) {
    Crossings c = crossingsOf(edges, axis, position, below);
    Box b = emptyBox();
    CLEAVE_UNROLL for (uint i = 0u; i < kMostEdges; i++) {
        if ((edges.used >> i & 1u) == 0u) continue;
        bool fromIn = isWithin(edges.from[i], axis, position, below);
        bool toIn = isWithin(edges.to[i], axis, position, below);
        bool isWhole = fromIn != toIn && i != c.first && i != c.last;
        if (fromIn || isWhole) b = including(b, edges.from[i]);
        if (toIn || isWhole) b = including(b, edges.to[i]);
    }
    if (c.first == kMostEdges) return b;
    b = including(b, cutEdge(c.inside0, c.outside0, axis, position));
    return including(b, cutEdge(c.inside1, c.outside1, axis, position));
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
    EdgeSet edges;
    CLEAVE_UNROLL for (uint i = 0u; i < kMostEdges; i++) {
        edges.from[i] = vec3(0.0f);
        edges.to[i] = vec3(0.0f);
    }
    edges.to[0] = t.b - t.a;
    edges.from[1] = edges.to[0];
    edges.to[1] = t.c - t.a;
    edges.from[2] = edges.to[1];
    edges.used = 7u;
    float extent = max(largestComponent(edges.to[0]), largestComponent(edges.to[1]));
    precise float margin = 7.62939453125e-06f * extent + kSmallestNormal;
    Box bounds = triangleBox(t);
    for (uint plane = 0u; plane < 6u; plane++) {
        uint axis = plane >> 1;
        bool below = (plane & 1u) != 0u;
        if (below ? bounds.hi[axis] <= box.hi[axis] : bounds.lo[axis] >= box.lo[axis]) continue;
        precise float position = (below ? box.hi[axis] : box.lo[axis]) - t.a[axis];
        position = below ? position + margin : position - margin;
        edges = cutAt(edges, axis, position, below, 3u + plane);
    }
    precise float position = split - t.a[splitAxis];
    SplitBoxes s;
    Box l = boxWithin(edges, splitAxis, position + margin, true);
    Box r = boxWithin(edges, splitAxis, position - margin, false);
    s.left = placedBox(l, t.a, margin, leftOf(box, splitAxis, split), bounds);
    s.right = placedBox(r, t.a, margin, rightOf(box, splitAxis, split), bounds);
    return s;
}

CLEAVE_END
#endif
