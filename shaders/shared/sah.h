// The surface area heuristic (survey, section 4), one text for GPU, twin and exact builder. Costs are multiplied out by
// the node's area, since division differs between devices:
//   cost * area = costTraverse area + costIntersect (area_L n_L + area_R n_R) + costLeaf (area_L + area_R)
#ifndef CLEAVE_SHARED_SAH_H
#define CLEAVE_SHARED_SAH_H
#include "box.h"
#include "config.h"
#include "kd_node.h"

CLEAVE_BEGIN

// A candidate plane. A straddling reference counts on both sides; a planar one (flat, in the plane) on one side only.
struct Split {
    float cost;  // multiplied by half the node's surface area; +inf: no split
    uint axis;
    float position;
    uint planarLeft;  // 1: planar references go left, 0: right
};
CLEAVE_SIZE(Split, 16);

CLEAVE_FN Split noSplit() {
    Split s;
    s.cost = infinity();
    s.axis = kLeafAxis;
    s.position = 0.0f;
    s.planarLeft = 1u;
    return s;
}

// Half the surface of a box with these extents. Denormal products count as zero.
CLEAVE_FN float halfArea(vec3 e) {
    precise float xy = flushed(e.x * e.y);
    precise float yz = flushed(e.y * e.z);
    precise float zx = flushed(e.z * e.x);
    precise float area = xy + yz;
    area = area + zx;
    return area;
}

CLEAVE_FN float leafCost(SahCosts costs, Box cell, uint count) {
    precise float area = halfArea(cell.hi - cell.lo);
    precise float cost = costs.intersect * float(count) * area;
    precise float visit = costs.leaf * area;
    cost = cost + visit;
    return cost;
}

// A child shares the extents a, b across the split axis, so half its surface is a b + (a + b) length. Both children are
// taken for leaves.
CLEAVE_FN float splitCost(SahCosts costs, Box cell, uint axis, float position, uint leftCount, uint rightCount) {
    vec3 e = cell.hi - cell.lo;
    float a = axis == 0u ? e.y : e.x;
    float b = axis == 2u ? e.y : e.z;
    precise float face = flushed(a * b);
    precise float rim = a + b;
    precise float whole = flushed(rim * (axis == 0u ? e.x : axis == 1u ? e.y : e.z));
    precise float left = flushed(rim * (position - cell.lo[axis]));
    precise float right = flushed(rim * (cell.hi[axis] - position));
    whole = whole + face;
    left = left + face;
    right = right + face;
    precise float visits = left + right;
    left = left * float(leftCount);
    right = right * float(rightCount);
    precise float both = left + right;
    precise float cost = costs.intersect * both;
    precise float start = costs.traverse * whole;
    cost = start + cost;
    visits = costs.leaf * visits;
    cost = cost + visits;
    if (leftCount == 0u || rightCount == 0u) cost = costs.emptyBonus * cost;
    return cost;
}

// The total order of candidates: cost, then axis, then position, then planar references left.
CLEAVE_FN bool isBetter(Split a, Split b) {
    if (a.cost != b.cost) return a.cost < b.cost;
    if (a.axis != b.axis) return a.axis < b.axis;
    if (a.position != b.position) return a.position < b.position;
    return a.planarLeft > b.planarLeft;
}

// Whether a plane is a candidate: it must lie strictly inside the cell.
CLEAVE_FN bool isInside(Box cell, uint axis, float position) {
    return cell.lo[axis] < position && position < cell.hi[axis];
}

// The better of `best` and one candidate.
CLEAVE_FN Split betterOf(Split best, SahCosts costs, Box cell, uint axis, float position, uint leftCount,
                         uint rightCount, uint planarLeft) {
    if (!isInside(cell, axis, position)) return best;
    Split s;
    s.axis = axis;
    s.position = position;
    s.planarLeft = planarLeft;
    s.cost = splitCost(costs, cell, axis, position, leftCount, rightCount);
    if (isBetter(s, best)) return s;
    return best;
}

// The better of `best` and a plane at `position`. `left` references begin below it, `right` end above it and `planar`
// lie in it; these are tried on either side.
CLEAVE_FN Split betterOfBothSides(Split best, SahCosts costs, Box cell, uint axis, float position, uint left,
                                  uint right, uint planar) {
    best = betterOf(best, costs, cell, axis, position, left + planar, right, 1u);
    if (planar > 0u) best = betterOf(best, costs, cell, axis, position, left, right + planar, 0u);
    return best;
}

// A node is split iff that costs less than a leaf. `depth` is the node's own.
CLEAVE_FN bool isWorthwhile(SahCosts costs, Split s, Box cell, uint count, uint depth, uint maxDepth) {
    return depth < maxDepth && collapsedAxes(cell) < 2u && s.cost < leafCost(costs, cell, count);
}

// Where a reference goes: bit 0 left, bit 1 right. The only place that decides it, by comparing floats.
CLEAVE_CONST uint kLeft = 1u;
CLEAVE_CONST uint kRight = 2u;
CLEAVE_FN uint sideOf(float lo, float hi, float position, uint planarLeft) {
    if (lo == hi && lo == position) return planarLeft != 0u ? kLeft : kRight;
    return (lo < position ? kLeft : 0u) | (hi > position ? kRight : 0u);
}

CLEAVE_END
#endif
