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

// Sorts a hit into a row of which `written` are there. Nearly always it is the last; of a full row the last falls out.
void sortIn(CleaveHit hit, uint first, inout uint written) {
    uint at = first + written;
    if (written < push.hitsPerRay) written++;
    else if (cleaveIsCloser(hit, push.hits.at[at - 1u])) at--;
    else return;
    for (; at > first && cleaveIsCloser(hit, push.hits.at[at - 1u]); at--) push.hits.at[at] = push.hits.at[at - 1u];
    push.hits.at[at] = hit;
}

// Returns how many there are.
uint writeCrossings(CleaveRay ray, uint first) {
    CleaveTreeParts parts = cleavePartsOf(push.tree);
    CleaveScaledRay scaled = cleaveScaledRay(ray, push.tree.at.exponent);
    CleaveMark after = cleaveBeforeAll();
    uint written = 0u;
    while (written < push.hitsPerRay) {
        CleaveScaledRay rest = cleaveRestOf(scaled, after);
        CleaveCrossingList list = cleaveCollect(parts, rest, after, min(push.hitsPerRay - written, kCleaveCrossings));
        bool goesOn = cleaveIsFull(list);
        CleaveMark last = cleaveBeforeAll();
        for (uint k = 0u; k <= kCleaveCrossings; k++) {
            uint index = cleaveCrossingAt(list, k);
            if (index == kCleaveNone) continue;
            CleaveDecided d = cleaveDecideCrossing(parts, rest, after, index);
            // The one that waited comes next time if it is behind the others.
            if (!d.counts || (k == kCleaveCrossings && goesOn && cleaveIsBehind(d.hit, last))) continue;
            sortIn(d.hit, first, written);
            if (cleaveIsBehind(d.hit, last)) last = cleaveMarkAt(d.hit);
        }
        if (!goesOn) return written;
        after = last;
    }
    return written;
}

// Fills a row up with misses, by stores of 64 bits where they are aligned: some devices, lavapipe among them, pay by the
// store and lane, and most of a row may be misses.
void fillUp(uint first, uint written) {
    uint end = first + push.hitsPerRay;
    if ((uvec2(push.hits).x & 7u) != 0u) {
        for (uint i = first + written; i < end; i++) push.hits.at[i] = cleaveMissedHit();
        return;
    }
    CleavePairArray halves = CleavePairArray(uvec2(push.hits));
    double tAndNumber = packDouble2x32(uvec2(floatBitsToUint(cleaveInfinity()), kCleaveNone));
    for (uint i = first + written; i < end; i++) {
        halves.at[2u * i] = tAndNumber;
        halves.at[2u * i + 1u] = packDouble2x32(uvec2(0u));
    }
}

void main() {
    uint i = groupIndex() * kGroup + gl_LocalInvocationID.x;
    if (i >= push.rayCount) return;
    CleaveRay ray = push.rays.at[i];
    uint first = i * push.hitsPerRay;
    uint written = 0u;
    if (cleaveIsValidRay(ray)) written = writeCrossings(ray, first);
    else if ((push.flags & kCleaveTraceCounters) != 0u) atomicAdd(push.counters.at.invalidRays, 1u);
    fillUp(first, written);
}
