// Axis-aligned boxes.
#ifndef CLEAVE_SHARED_BOX_H
#define CLEAVE_SHARED_BOX_H
#include "language.h"

CLEAVE_BEGIN

struct Box {
    vec3 lo;
    vec3 hi;
};
CLEAVE_SIZE(Box, 24);

CLEAVE_FN Box emptyBox() {
    Box b;
    b.lo = vec3(infinity());
    b.hi = vec3(-infinity());
    return b;
}

CLEAVE_FN bool isEmpty(Box b) { return b.lo.x > b.hi.x || b.lo.y > b.hi.y || b.lo.z > b.hi.z; }

CLEAVE_FN Box intersection(Box a, Box b) {
    Box r;
    r.lo = vec3(max(a.lo.x, b.lo.x), max(a.lo.y, b.lo.y), max(a.lo.z, b.lo.z));
    r.hi = vec3(min(a.hi.x, b.hi.x), min(a.hi.y, b.hi.y), min(a.hi.z, b.hi.z));
    return r;
}

CLEAVE_FN Box including(Box b, vec3 p) {
    Box r;
    r.lo = vec3(min(b.lo.x, p.x), min(b.lo.y, p.y), min(b.lo.z, p.z));
    r.hi = vec3(max(b.hi.x, p.x), max(b.hi.y, p.y), max(b.hi.z, p.z));
    return r;
}

// The part of `cell` on one side of the plane x[axis] = position.
CLEAVE_FN Box leftOf(Box cell, uint axis, float position) {
    cell.hi[axis] = position;
    return cell;
}
CLEAVE_FN Box rightOf(Box cell, uint axis, float position) {
    cell.lo[axis] = position;
    return cell;
}

// Axes along which the box has an extent below the smallest normal number.
CLEAVE_FN uint collapsedAxes(Box b) {
    return (b.hi.x - b.lo.x < kSmallestNormal ? 1u : 0u) + (b.hi.y - b.lo.y < kSmallestNormal ? 1u : 0u) +
           (b.hi.z - b.lo.z < kSmallestNormal ? 1u : 0u);
}

CLEAVE_END
#endif
