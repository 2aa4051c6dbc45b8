// Packs what a workgroup of kGroup invocations keeps: on devices that run a few lanes at a time, a few rays that go on
// among many that have ended would cost as much as all.

shared uint keptLanes[(kGroup + 31u) / 32u];

// Where this invocation's item goes in the workgroup's part of an array: those that are kept come first, both kinds in
// their order. Called by all of them alike.
uint packedPlace(bool isKept) {
    uint lane = gl_LocalInvocationID.x;
    barrier();
    if (lane < keptLanes.length()) keptLanes[lane] = 0u;
    barrier();
    if (isKept) atomicOr(keptLanes[lane / 32u], 1u << (lane % 32u));
    barrier();
    uint before = bitCount(keptLanes[lane / 32u] & ((1u << (lane % 32u)) - 1u));
    uint all = 0u;
    for (uint w = 0u; w < keptLanes.length(); w++) {
        uint count = uint(bitCount(keptLanes[w]));
        if (w < lane / 32u) before += count;
        all += count;
    }
    return isKept ? before : all + lane - before;
}
