// What every traversal does at the root, at a plane and in a leaf.
//
// Child selection is conservative: the t of a plane carries a relative error of 7 u (difference u, reciprocal 5 u,
// product u; u = 2^-24) and intervals are widened by 16 u, so that no cell that the ray meets is passed over.

layout(constant_id = 0) const bool kAnyHit = false;
layout(constant_id = 1) const bool kCountSteps = false;
layout(constant_id = 2) const uint kTriangleTest = kWatertightTest;
layout(push_constant, scalar) uniform Push { TracePush push; };

const float kWiden = 9.5367431640625e-07;  // 2^-20 = 16 u
const float kLargeT = 3.0e38;

// A node, and the part of the ray that may lie in its cell.
struct Visit {
    uint node;
    float tMin;
    float tMax;
};

// The part of the ray in the root cell, widened; false if there is none.
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

// Which children the ray may meet, and where it passes from one to the other.
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
    if (ray.direction[axis] == 0.0) {  // parallel to the plane: one side, or both where the ray lies in it
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
    if (kTriangleTest == kPlainTest) return plainTriangle(ray.origin, ray.direction, t);
    if (kTriangleTest == kWatertightTest && clearlyMisses(ray.origin, ray.direction, t.a, t.b, t.c)) return missedHit();
    if (kCountSteps) steps.resolved++;
    return resolveTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
}

// Keeps the best hit, from whichever leaf finds it; true if it is from this leaf.
bool testLeaf(ScaledRay ray, KdNode leaf, inout Hit best, inout StepCount steps) {
    bool found = false;
    uint first = leafFirst(leaf);
    uint count = leafCount(leaf);
    if (kCountSteps) {
        steps.leaves++;
        steps.triangles += count;
    }
    for (uint i = 0u; i < count; i++) {
        uint prim = push.leafTriangles.at[first + i];
        Hit h = testTriangle(ray, push.triangles.at[prim], steps);
        h.prim = prim;
        if (h.t >= ray.tMin && h.t <= ray.tMax && h.t < infinity() && isCloser(h, best)) {
            best = h;
            found = true;
            if (kAnyHit) break;
        }
    }
    if (kCountSteps && found) steps.hitLeaf = count;
    return found;
}
