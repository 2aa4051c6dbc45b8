#version 460
// Finds the first hitsPerRay crossings of each ray, by the rule "once" (shared/crossing.h). An invocation per ray; misses
// fill up its row.
#extension GL_GOOGLE_include_directive : require
#include "shared/config.h"
#include "lib/group.glsl"

layout(local_size_x = kGroup) in;
#include "cleave.glsl"
#include "trace_push.glsl"

layout(push_constant, scalar) uniform Push { CleaveTracePush push; };

// Returns how many there are.
uint writeCrossings(CleaveRay ray, uint first) {
    CleaveTreeParts parts = cleavePartsOf(push.tree);
    CleaveScaledRay scaled = cleaveScaledRay(ray, push.tree.at.exponent);
    CleaveMark after = cleaveBeforeAll();
    uint written = 0u;
    while (written < push.hitsPerRay) {
        uint wanted = min(push.hitsPerRay - written, kCleaveCrossings);
        CleaveCrossingList list = cleaveCollect(parts, scaled, after, wanted);
        for (uint k = kCleaveCrossings - wanted; k < kCleaveCrossings; k++) {
            if (list.index[k] == kCleaveNone) return written;
            push.hits.at[first + written] = cleaveCrossingHit(parts, scaled, list.t[k], list.index[k]);
            written++;
        }
        after = cleaveMarkOf(parts, list.t[kCleaveLastCrossing], list.index[kCleaveLastCrossing]);
    }
    return written;
}

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    CleaveRay ray = push.rays.at[i];
    uint first = i * push.hitsPerRay;
    uint written = 0u;
    if (cleaveIsValidRay(ray)) written = writeCrossings(ray, first);
    else if ((push.flags & kCleaveTraceCounters) != 0u) atomicAdd(push.counters.at.invalidRays, 1u);
    for (; written < push.hitsPerRay; written++) push.hits.at[first + written] = cleaveMissedHit();
}
