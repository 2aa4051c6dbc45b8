// Stack-less traversal: descend from the restart node to a leaf, then again for what is left, guided by the trail.
//
// Child selection is conservative: the t of a plane carries a relative error of 7 u (difference u, reciprocal 5 u,
// product u; u = 2^-24) and intervals are widened by 16 u, so that no cell that the ray meets is passed over. Widened
// intervals overlap, so t cannot prove progress; the trail does. Whether a node has one or two children to visit is
// decided from the ray's own interval, never from the shrunk one, so that it comes out alike on each descent.
#include "shared/trail.h"

const float kWiden = 9.5367431640625e-07;  // 2^-20 = 16 u
const float kLargeT = 3.0e38;

struct Descent {
    uint node;
    uint depth;
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

// Keeps the best hit, from whichever leaf finds it; true if it is from this leaf.
bool testLeaf(ScaledRay ray, KdNode leaf, inout Hit best) {
    bool found = false;
    uint first = leafFirst(leaf);
    uint count = leafCount(leaf);
    for (uint i = 0u; i < count; i++) {
        uint prim = push.leafTriangles.at[first + i];
        Hit h = intersectTriangle(ray.origin, ray.direction, push.triangles.at[prim]);
        h.prim = prim;
        if (h.t >= ray.tMin && h.t <= ray.tMax && h.t < infinity() && isCloser(h, best)) {
            best = h;
            found = true;
            if (kAnyHit) return true;
        }
    }
    return found;
}

// The answer for a valid ray, t in scaled units.
Hit traverse(ScaledRay ray, inout StepCount steps, out bool capped) {
    capped = false;
    Hit best = missedHit();
    vec3 inverse = vec3(1.0) / ray.direction;  // not used where the direction is 0
    Descent start;
    start.node = 0u;
    start.depth = 0u;
    if (!enterRoot(ray, inverse, push.bounds, start.tMin, start.tMax)) return best;
    Trail trail = emptyTrail();
    uint visited = 0u;
    while (true) {
        Descent at = start;
        float pending = infinity();  // no point of a cell that is still to be visited has a smaller t
        KdNode node = push.nodes.at[at.node];
        while (!isLeaf(node) && at.tMin <= best.t) {
            visited++;
            if (kCountSteps) steps.inner++;
            uint axis = nodeAxis(node);
            float toPlane = nodePosition(node) - ray.origin[axis];
            bool inPlaneDirection = ray.direction[axis] == 0.0;
            float t = clamp(toPlane * inverse[axis], -kLargeT, kLargeT);
            float tLow = t - abs(t) * kWiden;
            float tHigh = t + abs(t) * kWiden;
            bool goNear = at.tMin <= tHigh;
            bool goFar = at.tMax >= tLow;
            uint near = ray.direction[axis] < 0.0 ? 1u : 0u;  // the child that comes first along the ray
            if (inPlaneDirection) {  // parallel to the plane: one side, or both where the ray lies in it
                goNear = toPlane >= 0.0;
                goFar = toPlane <= 0.0;
                tLow = -kLargeT;
                tHigh = kLargeT;
            }
            bool takeFar = !goNear;
            if (goNear && goFar) takeFar = trailBit(trail, at.depth);
            else trail = withBit(trail, at.depth);
            if (takeFar) {
                at.tMin = max(at.tMin, tLow);
            } else {
                at.tMax = min(at.tMax, tHigh);
                if (goFar) pending = min(pending, tLow);
            }
            at.node = nodeChild(node) + (takeFar ? 1u - near : near);
            at.depth++;
            if (pending == infinity()) start = at;  // push-down: nothing above is left to visit
            node = push.nodes.at[at.node];
        }
        if (isLeaf(node) && at.tMin <= best.t) {
            if (kCountSteps) {
                steps.leaves++;
                steps.triangles += leafCount(node);
            }
            bool found = testLeaf(ray, node, best);
            if (kCountSteps && found) steps.hitLeaf = leafCount(node);
            if (kAnyHit && found) return best;
        }
        // A tie goes to the lower number, so a cell that begins at the best t must still be seen.
        if (pending == infinity() || best.t < pending) return best;
        if (visited > kStepCap) {
            capped = true;
            return missedHit();
        }
        trail = advanced(trail, at.depth);
        if (kCountSteps) steps.restarts++;
    }
    return best;
}
