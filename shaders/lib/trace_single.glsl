// The body of the kernels for scenes that are too small for a tree: the root is a leaf, and all of its triangles are
// tested. Answers are those of trace_main.glsl. Without a walk, and with a single place where hits are decided, a device
// that translates kernels at every start, as lavapipe does, is soon done.
#include "shared/config.h"
#include "shared/trace.h"
#include "shared/ray.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
layout(constant_id = 0) const bool kAnyHit = false;

// What a kernel is given beside it, and which triangles rays may look through, as in trace_main.glsl.
#ifndef CLEAVE_MORE_PUSH
#define CLEAVE_MORE_PUSH
#endif
#ifndef CLEAVE_IS_OPAQUE
#define CLEAVE_IS_OPAQUE(number) true
#define CLEAVE_ACCEPTS(number, u, v) true
#endif
layout(push_constant, scalar) uniform Push { TracePush push; CLEAVE_MORE_PUSH };

// The best hit among all triangles, in scaled units.
Hit bestOfAll(Tree tree, ScaledRay ray) {
    Hit best = missedHit();
    best.t = ray.tMax;
    uint count = leafCount(tree.at.nodes.at[0]);
    for (uint i = 0u; i < count; i++) {
        TreeTriangle t = tree.at.triangles.at[tree.at.leafRefs.at[i]];
        FilteredHit f = filterTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
        if (f.misses || f.tLow > best.t || f.tHigh < ray.tMin) continue;
        Hit h = resolveTriangle(ray.origin, ray.direction, t.a, t.b, t.c);
        if (h.t < ray.tMin || h.t > best.t || h.t == infinity()) continue;
        if (h.t == best.t && t.number > best.prim) continue;
        if (!CLEAVE_IS_OPAQUE(t.number) && !CLEAVE_ACCEPTS(t.number, h.u, h.v)) continue;
        best = h;
        best.prim = t.number;
        if (kAnyHit) break;
    }
    return best;
}

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    Ray ray = push.rays.at[i];
    bool valid = isValidRay(ray);
    Hit hit = missedHit();
    if (valid) {
        ScaledRay scaled = scaledRay(ray, push.tree.at.exponent);
        Hit best = bestOfAll(push.tree, scaled);
        if (best.prim != kNone) hit = worldHit(best, scaled.tExponent);
    }
    if (!valid && (push.flags & kTraceCounters) != 0u) atomicAdd(push.counters.at.invalidRays, 1u);
    if ((push.flags & kTraceTrails) != 0u) push.trails.at[i] = finishedTrail();
    push.hits.at[i] = hit;
}
