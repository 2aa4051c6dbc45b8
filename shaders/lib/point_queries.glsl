// Queries of points and boxes in a tree.
#ifndef CLEAVE_LIB_POINT_QUERIES
#define CLEAVE_LIB_POINT_QUERIES
#include "shared/config.h"
#include "shared/nearest_point.h"
#include "shared/overlap.h"
#include "shared/query.h"
#include "lib/crossings.glsl"

// How a walk answers for the triangles that meet a box: whether there is one, how many entries of leaves there are, or
// by writing their numbers.
const uint kAnyOverlap = 0u;
const uint kCountOverlaps = 1u;
const uint kWriteOverlaps = 2u;

// Visits all leaves whose closed cells meet the box. A triangle has each of its points in a closed cell that lists it, so
// none is passed over; one that is listed in several of these leaves counts several times.
uint overlaps(TreeParts tree, Box box, uint how, UintArray numbers, uint first) {
    uint waiting[kMaxDepth];
    uint depth = 0u;
    uint count = 0u;
    uint at = 0u;
    while (true) {
        KdNode node = nodeAt(tree, at);
        while (!isLeaf(node)) {
            float plane = nodePosition(node);
            bool left = box.lo[nodeAxis(node)] <= plane;
            bool right = box.hi[nodeAxis(node)] >= plane;
            if (left && right) {
                waiting[depth] = nodeChild(node) + 1u;
                depth++;
            }
            node = nodeAt(tree, at = nodeChild(node) + (left ? 0u : 1u));
        }
        uint end = leafFirst(node) + leafCount(node);
        for (uint i = leafFirst(node); i < end; i++) {
            TreeTriangle t = triangleAt(tree, tree.leafRefs.at[i]);
            if (!meetsBox(withoutNumber(t), box)) continue;
            if (how == kAnyOverlap) return 1u;
            if (how == kWriteOverlaps) numbers.at[first + count] = t.number;
            count++;
        }
        if (depth == 0u) return count;
        depth--;
        at = waiting[depth];
    }
    return count;
}

bool isIn(Box bounds, vec3 point) {
    for (uint axis = 0u; axis < 3u; axis++)
        if (point[axis] < bounds.lo[axis] || point[axis] > bounds.hi[axis]) return false;
    return true;
}

// Whether a point is inside of a closed surface or on it.
bool contains(Tree tree, vec3 point) {
    if (!isFinite3(point)) return false;
    TreeParts parts = partsOf(tree);
    Box here;
    here.lo = timesPowerOfTwo(point, -tree.at.exponent);
    here.hi = here.lo;
    if (!isIn(parts.bounds, here.lo)) return false;
    if (overlaps(parts, here, kAnyOverlap, UintArray(uvec2(0u)), 0u) > 0u) return true;
    Ray ray;
    ray.origin = point;
    ray.tMin = 0.0;
    ray.direction = containmentDirection();
    ray.tMax = infinity();
    return (crossings(tree, ray, false) & 1) != 0;
}

double squareOf(dvec3 v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

// How far a point is from a box along each axis; at most the largest float.
vec3 gapTo(Box box, dvec3 p) {
    vec3 gap;
    for (uint axis = 0u; axis < 3u; axis++) {
        double below = double(box.lo[axis]) - p[axis];
        double above = p[axis] - double(box.hi[axis]);
        double most = below > above ? below : above;
        gap[axis] = most > 0.0 ? float(min(most, double(kLargestFloat))) : 0.0;
    }
    return gap;
}

// The square of the scaled distance beyond which nothing is nearer than `best`, nor as near: distances, and the gaps of
// cells, are rounded to float.
double squareLimit(float best, int exponent) {
    double scaled = double(max(best, kSmallestNormal)) * powerOfTwo(-exponent) * (1.0 + powerOfTwo(-20));
    return scaled * scaled;
}

void nearestInLeaf(TreeParts tree, KdNode leaf, dvec3 point, int exponent, inout Hit best, inout double limit) {
    uint end = leafFirst(leaf) + leafCount(leaf);
    for (uint i = leafFirst(leaf); i < end; i++) {
        TreeTriangle t = triangleAt(tree, tree.leafRefs.at[i]);
        if (t.number == best.prim || squareOf(dvec3(gapTo(triangleBox(withoutNumber(t)), point))) > limit) continue;
        NearPoint near = nearestPoint(point, withoutNumber(t));
        Hit h;
        h.t = worldDistance(near, exponent);
        h.prim = t.number;
        h.u = float(near.u);
        h.v = float(near.v);
        if (h.t == infinity() || !isCloser(h, best)) continue;
        best = h;
        limit = squareLimit(best.t, exponent);
    }
}

// The nearest point of the tree's triangles that is at most `within` away: t is the distance. Branch and bound: a cell
// waits with its gaps along the axes, of which a plane changes one (Arya and Mount 1993).
Hit nearest(Tree tree, vec3 point, float within) {
    Hit best = missedHit();
    if (!isFinite3(point) || !(within >= 0.0)) return best;
    best.t = within;
    TreeParts parts = partsOf(tree);
    int exponent = tree.at.exponent;
    dvec3 p = scaledPoint(point, exponent);
    double limit = squareLimit(best.t, exponent);
    uvec4 waiting[kMaxDepth];
    uint depth = 0u;
    uint at = 0u;
    vec3 gap = gapTo(parts.bounds, p);
    while (squareOf(dvec3(gap)) <= limit) {
        KdNode node = nodeAt(parts, at);
        while (!isLeaf(node)) {
            double below = double(nodePosition(node)) - p[nodeAxis(node)];
            uint near = below > 0.0 ? 0u : 1u;
            vec3 far = gap;
            far[nodeAxis(node)] = float(min(abs(below), double(kLargestFloat)));
            if (squareOf(dvec3(far)) <= limit) {
                waiting[depth] = uvec4(nodeChild(node) + 1u - near, floatBitsToUint(far));
                depth++;
            }
            at = nodeChild(node) + near;
            node = nodeAt(parts, at);
        }
        nearestInLeaf(parts, node, p, exponent, best, limit);
        do {
            if (depth == 0u) return best.prim == kNone ? missedHit() : best;
            depth--;
            at = waiting[depth].x;
            gap = uintBitsToFloat(waiting[depth].yzw);
        } while (squareOf(dvec3(gap)) > limit);
    }
    return best.prim == kNone ? missedHit() : best;
}
#endif
