// The steps that all traversals share: at the root, at a plane and in a leaf.
//
// Child selection is conservative. The t of a plane has a relative error of at most 7 u (difference u, reciprocal 5 u,
// product u; u = 2^-24), and intervals are widened by 16 u, so that no cell that the ray meets is skipped.
#ifndef CLEAVE_LIB_WALK
#define CLEAVE_LIB_WALK
#include "shared/step_count.h"
#include "shared/tree.h"

// The triangle test: kWatertightTest, kPlainTest or kUnfilteredTest.
#ifndef CLEAVE_TEST
#define CLEAVE_TEST kWatertightTest
#endif

// Whether the work of rays is counted.
#ifndef CLEAVE_COUNT_STEPS
#define CLEAVE_COUNT_STEPS false
#endif

const float kWiden = 9.5367431640625e-07;  // 2^-20 = 16 u
const float kLargeT = 3.0e38;

// The parts of a tree that traversal reads, loaded once: not all compilers move loads out of loops.
struct TreeParts {
    KdNodeArray nodes;
    UintArray leafRefs;
    TriangleArray triangles;
    UintArray numbers;
    bool hasNumbers;
    Box bounds;
};

TreeParts partsOf(Tree tree) {
    TreeParts p;
    p.nodes = tree.at.nodes;
    p.leafRefs = tree.at.leafRefs;
    p.triangles = tree.at.triangles;
    p.numbers = tree.at.numbers;
    p.hasNumbers = uvec2(p.numbers) != uvec2(0u);
    p.bounds = tree.at.bounds;
    return p;
}

// A node, and the part of the ray that may lie in its cell.
struct Visit {
    uint node;
    float tMin;
    float tMax;
};

// Clips the ray to the root cell, widened; false if nothing is left.
bool enterRoot(ScaledRay ray, vec3 inverse, Box box, out float tMin, out float tMax) {
    tMin = ray.tMin;
    tMax = ray.tMax;
    for (uint axis = 0u; axis < 3u; axis++) {
        float o = ray.origin[axis];
        if (ray.direction[axis] == 0.0) {
            if (o < box.lo[axis] || o > box.hi[axis]) return false;
            continue;
        }
        float a = clamp((box.lo[axis] - o) * inverse[axis], -kLargeT, kLargeT);
        float b = clamp((box.hi[axis] - o) * inverse[axis], -kLargeT, kLargeT);
        float enter = min(a, b);
        float leave = max(a, b);
        tMin = max(tMin, enter - abs(enter) * kWiden);
        tMax = min(tMax, leave + abs(leave) * kWiden);
    }
    return tMin <= tMax;
}

// The children that the ray may meet, and where it passes from one to the other.
struct PlaneStep {
    uint near;  // the child that comes first along the ray: 0 left, 1 right
    bool goNear;
    bool goFar;
    float tLow;  // of the plane, widened
    float tHigh;
};

PlaneStep stepAt(KdNode node, ScaledRay ray, vec3 inverse, float tMin, float tMax) {
    uint axis = nodeAxis(node);
    float toPlane = nodePosition(node) - ray.origin[axis];
    PlaneStep s;
    s.near = ray.direction[axis] < 0.0 ? 1u : 0u;
    if (ray.direction[axis] == 0.0) {  // parallel to the plane: meets one child, or both where it lies in the plane
        s.goNear = toPlane >= 0.0;
        s.goFar = toPlane <= 0.0;
        s.tLow = -kLargeT;
        s.tHigh = kLargeT;
        return s;
    }
    float t = clamp(toPlane * inverse[axis], -kLargeT, kLargeT);
    s.tLow = t - abs(t) * kWiden;
    s.tHigh = t + abs(t) * kWiden;
    s.goNear = tMin <= s.tHigh;
    s.goFar = tMax >= s.tLow;
    return s;
}

Hit testTriangle(ScaledRay ray, Triangle t, inout StepCount steps) {
    if (CLEAVE_TEST == kPlainTest) return plainTriangle(ray.origin, ray.direction, t);
    if (CLEAVE_TEST == kWatertightTest && clearlyMisses(ray.origin, ray.direction, t.a, t.b, t.c)) return missedHit();
    if (CLEAVE_COUNT_STEPS) steps.resolved++;
    return resolveTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
}

// Tests the triangles of a leaf and updates the best hit; true if it is now from this leaf. A triangle's number is
// looked up only if its hit is not farther than the best.
bool testLeaf(TreeParts tree, ScaledRay ray, KdNode leaf, bool anyHit, inout Hit best, inout StepCount steps) {
    bool found = false;
    uint first = leafFirst(leaf);
    uint count = leafCount(leaf);
    if (CLEAVE_COUNT_STEPS) {
        steps.leaves++;
        steps.triangles += count;
    }
    for (uint i = 0u; i < count; i++) {
        uint index = tree.leafRefs.at[first + i];
        Hit h = testTriangle(ray, tree.triangles.at[index], steps);
        if (h.t >= ray.tMin && h.t <= ray.tMax && h.t < infinity() && h.t <= best.t) {
            h.prim = tree.hasNumbers ? tree.numbers.at[index] : index;
            if (isCloser(h, best)) {
                best = h;
                found = true;
                if (anyHit) break;
            }
        }
    }
    if (CLEAVE_COUNT_STEPS && found) steps.hitLeaf = count;
    return found;
}
#endif
