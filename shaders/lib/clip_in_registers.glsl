// splitBoxes() of shared/clip.h with the same arithmetic and bits, for CPU devices. What is there an array of vertices
// with variable indices, which they load and store lane by lane, is here nine variables: loops over them are unrolled,
// and a vertex is picked by comparing numbers. Planes are cut in the same order, as many as any lane needs.
#include "shared/clip.h"

const uint kMostCorners = 9u;  // of a triangle cut by six planes

vec3 cornerOf(vec3 at[kMostCorners], uint index) {
    vec3 p = at[0];
    [[unroll]] for (uint i = 1u; i < kMostCorners; i++) p = index == i ? at[i] : p;
    return p;
}

// Which corners of a polygon lie on the inner side of a plane; a bit each.
uint cornersInside(vec3 at[kMostCorners], uint count, uint axis, float position, bool below) {
    uint inside = 0u;
    [[unroll]] for (uint i = 0u; i < kMostCorners; i++) {
        float x = at[i][axis];
        inside |= (below ? x <= position : x >= position) ? 1u << i : 0u;
    }
    return inside & ((1u << count) - 1u);
}

// Bits of a polygon's corners, those of corner `first` first.
uint turned(uint bits, uint first, uint count) { return (bits >> first | bits << (count - first)) & ((1u << count) - 1u); }

// Cuts a polygon, which is in part inside, by a plane.
void cutCorners(inout vec3 at[kMostCorners], inout uint count, uint inside, uint axis, float position) {
    uint first = lowestBit(inside & ~turned(inside, count - 1u, count));
    uint run = lowestBit(~turned(inside, first, count));
    vec3 from[kMostCorners];
    vec3 last = vec3(0.0f);
    vec3 after = vec3(0.0f);
    vec3 before = vec3(0.0f);
    [[unroll]] for (uint n = 0u; n < kMostCorners - 1u; n++) {
        uint index = first + n;
        vec3 p = cornerOf(at, index < count ? index : index - count);
        from[n] = p;
        last = n + 1u == run ? p : last;
        after = n == run ? p : after;
        before = n + 1u == count ? p : before;
    }
    vec3 leaves = cutEdge(last, after, axis, position);
    vec3 enters = cutEdge(from[0], before, axis, position);
    from[kMostCorners - 1u] = enters;
    [[unroll]] for (uint n = 0u; n < kMostCorners; n++) at[n] = n < run ? from[n] : n == run ? leaves : enters;
    count = run + 2u;
}

Box includingIf(Box b, vec3 p, bool isIn) {
    [[unroll]] for (uint k = 0u; k < 3u; k++) {
        b.lo[k] = isIn && p[k] < b.lo[k] ? p[k] : b.lo[k];
        b.hi[k] = isIn && p[k] > b.hi[k] ? p[k] : b.hi[k];
    }
    return b;
}

SplitBoxes splitBoxesInRegisters(Triangle t, Box box, uint splitAxis, float split) {
    vec3 at[kMostCorners];
    [[unroll]] for (uint i = 0u; i < kMostCorners; i++) at[i] = vec3(0.0f);
    at[1] = t.b - t.a;
    at[2] = t.c - t.a;
    uint count = 3u;
    float extent = max(largestComponent(at[1]), largestComponent(at[2]));
    precise float margin = 7.62939453125e-06f * extent + kSmallestNormal;
    Box bounds = triangleBox(t);
    uint planes = 0u;
    [[unroll]] for (uint axis = 0u; axis < 3u; axis++) {
        planes |= bounds.lo[axis] < box.lo[axis] ? 1u << 2u * axis : 0u;
        planes |= bounds.hi[axis] > box.hi[axis] ? 2u << 2u * axis : 0u;
    }
    do {
        uint plane = lowestBit(planes);
        uint axis = plane >> 1;
        bool below = (plane & 1u) != 0u;
        precise float position = (below ? box.hi[axis] : box.lo[axis]) - t.a[axis];
        position = below ? position + margin : position - margin;
        uint inside = cornersInside(at, count, axis, position, below);
        bool isCut = planes != 0u && inside != (1u << count) - 1u;
        planes &= planes - 1u;
        if (isCut && inside != 0u) cutCorners(at, count, inside, axis, position);
        if (isCut && inside == 0u) {
            count = 0u;
            planes = 0u;
        }
    } while (planes != 0u);
    precise float position = split - t.a[splitAxis];
    precise float toLeft = position + margin;
    precise float toRight = position - margin;
    uint left = cornersInside(at, count, splitAxis, toLeft, true);
    uint right = cornersInside(at, count, splitAxis, toRight, false);
    Box l = emptyBox();
    Box r = emptyBox();
    [[unroll]] for (uint i = 0u; i < kMostCorners; i++) {
        l = includingIf(l, at[i], (left >> i & 1u) != 0u);
        r = includingIf(r, at[i], (right >> i & 1u) != 0u);
    }
    // Where edges cross the planes: a bit each, those of the left part first.
    uint crossings = 0u;
    if (count > 0u) {
        crossings = (left ^ turned(left, 1u, count)) | (right ^ turned(right, 1u, count)) << kMostCorners;
    }
    do {
        uint crossing = lowestBit(crossings);
        bool isLeft = crossing < kMostCorners;
        uint i = isLeft ? crossing : crossing - kMostCorners;
        vec3 from = cornerOf(at, i);
        vec3 to = cornerOf(at, i + 1u < count ? i + 1u : 0u);
        bool fromIn = ((isLeft ? left : right) >> i & 1u) != 0u;
        vec3 p = cutEdge(fromIn ? from : to, fromIn ? to : from, splitAxis, isLeft ? toLeft : toRight);
        l = includingIf(l, p, isLeft && crossings != 0u);
        r = includingIf(r, p, !isLeft && crossings != 0u);
        crossings &= crossings - 1u;
    } while (crossings != 0u);
    SplitBoxes s;
    s.left = placedBox(l, t.a, margin, leftOf(box, splitAxis, split), bounds);
    s.right = placedBox(r, t.a, margin, rightOf(box, splitAxis, split), bounds);
    return s;
}
