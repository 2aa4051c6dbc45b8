// The steps that all traversals share: at the root, at a plane and in a leaf.
//
// Child selection is conservative. The t of a plane has a relative error of at most 7 u (difference u, reciprocal 5 u,
// product u; u = 2^-24), and intervals are widened by 16 u, so that no cell that the ray meets is skipped.
//
// Few triangle tests need double. Float arithmetic rejects clear misses, knows clear hits, and bounds their t; the hit
// that a walk ends with is decided in double once.
#ifndef CLEAVE_LIB_WALK
#define CLEAVE_LIB_WALK
#include "shared/step_count.h"
#include "shared/tree.h"

// The triangle test: kWatertightTest, kPlainTest or kUnfilteredTest.
#ifndef CLEAVE_TEST
#define CLEAVE_TEST kWatertightTest
#endif

// Whether the tree is that of a mesh that stands in a place: see lib/instances.glsl.
#ifndef CLEAVE_INSTANCES
#define CLEAVE_INSTANCES false
#endif

// Whether the work of rays is counted.
#ifndef CLEAVE_COUNT_STEPS
#define CLEAVE_COUNT_STEPS false
#endif

bool isAlwaysOpaque(uint number) { return true; }
bool acceptsAll(uint number, float u, float v) { return true; }

// Rays may look through triangles, where this is true. Of a triangle that is not opaque, by the function of this name, a hit counts if the
// other accepts it: it must say the same of the same hit of a ray, however often it is asked, and in any order.
#ifndef CLEAVE_LOOKS_THROUGH
#define CLEAVE_LOOKS_THROUGH false
#endif
#ifndef CLEAVE_IS_OPAQUE
#define CLEAVE_IS_OPAQUE isAlwaysOpaque
#endif
#ifndef CLEAVE_ACCEPTS
#define CLEAVE_ACCEPTS acceptsAll
#endif

bool isNowhereOpen(uint node) { return false; }

// Trees may have leaves that were left open (lazy building): a walk that comes to one, by the function of this name, ends
// there, unfinished, and goes on once the leaf has become a node.
#ifndef CLEAVE_LAZY
#define CLEAVE_LAZY false
#endif
#ifndef CLEAVE_IS_OPEN
#define CLEAVE_IS_OPEN isNowhereOpen
#endif

vec3 asItIs(vec3 vertex) { return vertex; }
uint asCounted(uint number) { return number; }
bool leavesNothingOut(vec3 a, vec3 b, vec3 c) { return false; }
float asMeasured(float t) { return t; }
void asTheRayIs(inout vec3 origin, inout float tMin, inout vec3 direction, inout float tMax, inout float error) {}

// Such a tree has its own space and numbers. Where its vertices are among the ray's, what number a triangle has in the
// scene, and which triangles do not count there:
#ifndef CLEAVE_PLACED_VERTEX
#define CLEAVE_PLACED_VERTEX asItIs
#endif
#ifndef CLEAVE_PLACED_NUMBER
#define CLEAVE_PLACED_NUMBER asCounted
#endif
#ifndef CLEAVE_LEAVES_OUT
#define CLEAVE_LEAVES_OUT leavesNothingOut
#endif

// The ray in the space of the tree, and how far from it, at its t, a point may be where the ray itself meets a
// triangle; and a t of the ray itself, rounded up, as one of that.
#ifndef CLEAVE_PLACED_RAY
#define CLEAVE_PLACED_RAY asTheRayIs
#endif
#ifndef CLEAVE_PLACED_T
#define CLEAVE_PLACED_T asMeasured
#endif

const float kWiden = 9.5367431640625e-07;  // 2^-20 = 16 u
const float kLargeT = 3.0e38;
const float kFar = 8.0;                 // rays that enter the root cell later than this are walked from there
const float kLeastDirection = 1.0e-20;  // see enterRoot()

// The parts of a tree that traversal reads, loaded once: not all compilers move loads out of loops.
struct TreeParts {
    PairArray nodes;  // KdNode
    UintArray leafRefs;
    PairArray triangles;  // TreeTriangle
    Box bounds;
};

TreeParts partsOf(Tree tree) {
    TreeParts p;
    p.nodes = PairArray(tree.at.nodes);
    p.leafRefs = tree.at.leafRefs;
    p.triangles = PairArray(tree.at.triangles);
    p.bounds = tree.at.bounds;
    return p;
}

// In one load of 64 bits: some devices, lavapipe among them, pay by the load and lane.
KdNode nodeAt(TreeParts tree, uint i) {
    uvec2 words = unpackDouble2x32(tree.nodes.at[i]);
    KdNode n;
    n.plane = words.x;
    n.link = words.y;
    return n;
}

// As rays are tested against it.
TreeTriangle triangleAt(TreeParts tree, uint i) {
    uvec2 w0 = unpackDouble2x32(tree.triangles.at[5u * i]);
    uvec2 w1 = unpackDouble2x32(tree.triangles.at[5u * i + 1u]);
    uvec2 w2 = unpackDouble2x32(tree.triangles.at[5u * i + 2u]);
    uvec2 w3 = unpackDouble2x32(tree.triangles.at[5u * i + 3u]);
    uvec2 w4 = unpackDouble2x32(tree.triangles.at[5u * i + 4u]);
    TreeTriangle t;
    t.a = uintBitsToFloat(uvec3(w0, w1.x));
    t.b = uintBitsToFloat(uvec3(w1.y, w2));
    t.c = uintBitsToFloat(uvec3(w3, w4.x));
    t.number = w4.y;
    if (CLEAVE_INSTANCES) {
        t.a = CLEAVE_PLACED_VERTEX(t.a);
        t.b = CLEAVE_PLACED_VERTEX(t.b);
        t.c = CLEAVE_PLACED_VERTEX(t.c);
        t.number = CLEAVE_PLACED_NUMBER(t.number);
    }
    return t;
}

// A ray on its way through the root cell, as planes see it. Its parameter counts from `start`. The plane at p along axis
// k is passed between (p - lowOrigin[k]) * lowInverse[k] and (p - highOrigin[k]) * highInverse[k]: errors are in these
// already, so that a step is short.
struct Walk {
    vec3 lowOrigin;
    vec3 highOrigin;
    vec3 lowInverse;
    vec3 highInverse;
    uint signs;  // bit k: component k of the direction is negative
    float start;
};

// A node, and the part of the ray that may lie in its cell.
struct Visit {
    uint node;
    float tMin;
    float tMax;
};

// Clips the part of a ray from tMin to tMax to a box, widened; false if nothing is left.
bool clipTo(Box box, vec3 origin, vec3 direction, vec3 inverse, float error, inout float tMin, inout float tMax) {
    for (uint axis = 0u; axis < 3u; axis++) {
        float lo = box.lo[axis] - error - origin[axis];
        float hi = box.hi[axis] + error - origin[axis];
        if (direction[axis] == 0.0) {
            if (lo > 0.0 || hi < 0.0) return false;
            continue;
        }
        float a = clamp(lo * inverse[axis], -kLargeT, kLargeT);
        float b = clamp(hi * inverse[axis], -kLargeT, kLargeT);
        float enter = min(a, b);
        float leave = max(a, b);
        tMin = max(tMin, enter - abs(enter) * kWiden);
        tMax = min(tMax, leave + abs(leave) * kWiden);
    }
    return tMin <= tMax;
}

// Clips the ray to the root cell and begins its walk; false if it misses the cell.
//
// A ray from far away is walked from where it enters the cell, so that errors of planes are of the cell's size and not
// of the distance. Its point there is rounded, at immense distances to any place: `error` says by how much.
//
// Components of the direction below 1e-20 count as that large, and planes within 4 units in the last place (and 3e-19)
// of the ray's coordinate there as planes that the ray lies in: it goes to one child, or to both where it lies in the
// plane, without a case of its own.
//
// The tree of a mesh is entered by the ray in its space, with the error of that.
bool enterRoot(Box box, ScaledRay ray, out Walk walk, out float tMin, out float tMax) {
    float error = 0.0;
    if (CLEAVE_INSTANCES) CLEAVE_PLACED_RAY(ray.origin, ray.tMin, ray.direction, ray.tMax, error);
    tMin = ray.tMin;
    tMax = ray.tMax;
    vec3 inverse = vec3(1.0) / ray.direction;
    vec3 origin = ray.origin;
    walk.start = 0.0;
    bool enters = clipTo(box, origin, ray.direction, inverse, error, tMin, tMax);
    if (enters && tMin > kFar) {
        // A little earlier, and the end a little later: the t of hits are rounded, and those at the ends count.
        walk.start = tMin * (1.0 - 2.0 * kWiden);
        vec3 entry = vec3(dvec3(ray.origin) + double(walk.start) * dvec3(ray.direction));
        origin = clamp(entry, box.lo - kFar, box.hi + kFar);
        error += 2.0e-6 + 9.0e-16 * largestComponent(ray.origin) + 1.001 * largestComponent(entry - origin);
        tMin = 0.0;
        tMax = tMax * (1.0 + 2.0 * kWiden) - walk.start;
        tMax += tMax * kWiden;
        enters = clipTo(box, origin, ray.direction, inverse, error, tMin, tMax);
    }
    walk.signs = 0u;
    for (uint axis = 0u; axis < 3u; axis++) {
        bool negative = ray.direction[axis] < 0.0;
        bool tiny = abs(ray.direction[axis]) < kLeastDirection;
        float along = tiny ? (negative ? -1.0 : 1.0) / kLeastDirection : inverse[axis];
        float around = error + (tiny ? abs(origin[axis]) * 2.4e-07 + 3.2e-19 : 0.0);
        float ahead = negative ? -around : around;
        if (negative) walk.signs |= 1u << axis;
        walk.lowOrigin[axis] = origin[axis] + ahead;
        walk.highOrigin[axis] = origin[axis] - ahead;
        walk.lowInverse[axis] = along * (1.0 - kWiden);
        walk.highInverse[axis] = along * (1.0 + kWiden);
    }
    return enters;
}

// The children that the ray may meet, and where it passes from one to the other.
struct PlaneStep {
    uint near;  // the child that comes first along the ray: 0 left, 1 right
    bool goNear;
    bool goFar;
    float tLow;  // of the plane, widened
    float tHigh;
};

// Where the plane is behind the ray's start, both t are negative, too.
PlaneStep stepAt(KdNode node, Walk walk, float tMin, float tMax) {
    uint axis = nodeAxis(node);
    float position = nodePosition(node);
    PlaneStep s;
    s.near = walk.signs >> axis & 1u;
    s.tLow = (position - walk.lowOrigin[axis]) * walk.lowInverse[axis];
    s.tHigh = (position - walk.highOrigin[axis]) * walk.highInverse[axis];
    s.goNear = tMin <= s.tHigh;
    s.goFar = tMax >= s.tLow;
    return s;
}

// The closest hit so far, as far as it is known: an interval of t, which is a point once the hit was decided in double.
struct Best {
    uint index;  // of the triangle in this tree; kNone: the hit that was given, or none
    uint number;
    float tLow;
    float tHigh;
};

// Before a walk: hits beyond the ray's end, or beyond the hit that is given, do not count.
Best bestOf(Hit given, ScaledRay ray) {
    bool within = given.t <= ray.tMax;
    Best b;
    b.index = kNone;
    b.number = within ? given.prim : kNone;
    b.tLow = within ? given.t : ray.tMax;
    b.tHigh = b.tLow;
    return b;
}

// The walk's parameter beyond which no hit is closer than `best`, nor as close: the t of hits are rounded.
float limitOf(Best best, Walk walk) {
    float t = best.tHigh + abs(best.tHigh) * kWiden;
    if (CLEAVE_INSTANCES) t = CLEAVE_PLACED_T(t);
    t -= walk.start;
    return t + abs(t) * kWiden;
}

// Whether the best hit comes back with the same bits from world units.
bool staysAsItIs(Best best, int tExponent) {
    return best.index == kNone || timesPowerOfTwo(best.tLow, tExponent) >= kSmallestNormal;
}

// Whether a ray waits at a leaf. It does not if it cannot come back with its best hit: open leaves list all triangles of
// their cells.
bool waitsAt(uint node, Best best, ScaledRay ray) {
    return CLEAVE_LAZY && staysAsItIs(best, ray.tExponent) && CLEAVE_IS_OPEN(node);
}

FilteredHit filtered(ScaledRay ray, TreeTriangle t) {
    if (CLEAVE_TEST == kWatertightTest) return filterTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
    FilteredHit unknown;
    unknown.misses = false;
    unknown.hits = false;
    unknown.tLow = -infinity();
    unknown.tHigh = infinity();
    return unknown;
}

Hit decided(ScaledRay ray, TreeTriangle t) {
    if (CLEAVE_INSTANCES && CLEAVE_LEAVES_OUT(t.a, t.b, t.c)) return missedHit();
    if (CLEAVE_TEST == kPlainTest) return plainTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
    return resolveTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
}

// Tests the triangles of a leaf and updates the best hit; true if it is now from this leaf. Double arithmetic decides
// what float leaves open: whether a triangle is hit, and which of two is closer. It may have to catch up on the best hit
// first; the triangle at hand then waits for its turn.
bool testLeaf(TreeParts tree, ScaledRay ray, KdNode leaf, bool anyHit, inout Best best, inout StepCount steps) {
    bool found = false;
    uint first = leafFirst(leaf);
    uint end = first + leafCount(leaf);
    if (CLEAVE_COUNT_STEPS) {
        steps.leaves++;
        steps.triangles += leafCount(leaf);
    }
    for (uint i = first; i < end; i++) {
        uint index = tree.leafRefs.at[i];
        if (index == best.index) continue;  // as it is in several leaves
        TreeTriangle t = triangleAt(tree, index);
        FilteredHit f = filtered(ray, t);
        if (f.misses || f.tLow > best.tHigh || f.tHigh < ray.tMin) continue;
        if (CLEAVE_LOOKS_THROUGH && !CLEAVE_IS_OPAQUE(t.number)) {
            Hit h = decided(ray, t);
            if (h.t == infinity() || !CLEAVE_ACCEPTS(t.number, h.u, h.v)) continue;
        }
        bool closer = f.hits && f.tLow >= ray.tMin && f.tHigh < best.tLow;
        if (!closer) {
            bool catchesUp = best.tLow < best.tHigh && f.tHigh >= best.tLow;
            if (catchesUp) t = triangleAt(tree, best.index);
            Hit h = decided(ray, t);
            if (CLEAVE_COUNT_STEPS && CLEAVE_TEST != kPlainTest) steps.resolved++;
            if (catchesUp) i--;
            else if (h.t < ray.tMin || h.t > best.tHigh || h.t == infinity()) continue;
            else if (h.t == best.tLow && t.number > best.number) continue;
            index = catchesUp ? best.index : index;
            f.tLow = h.t;
            f.tHigh = h.t;
        }
        best.index = index;
        best.number = t.number;
        best.tLow = f.tLow;
        best.tHigh = f.tHigh;
        found = true;
        if (anyHit) break;
    }
    if (CLEAVE_COUNT_STEPS && found) steps.hitLeaf = leafCount(leaf);
    return found;
}

// The best hit, of this tree, decided.
Hit hitOf(TreeParts tree, ScaledRay ray, Best best) {
    Hit h = decided(ray, triangleAt(tree, best.index));
    h.prim = best.number;
    return h;
}
#endif
