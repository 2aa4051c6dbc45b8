// Reads what a workgroup is about to read, a word of each cache line, so that many lines are on their way at a time. CPU
// devices load by address, lane by lane, which their prefetchers do not follow, and a pass over a large level would wait for
// one group of lines after the other. `step`: of the references of chunk or block only every step-th will be read. True,
// always, since a node's number is never kNone; that must be looked at, for the reads to happen.
bool touch(PrimRefArray refs, uint first, uint end, uint step) {
    const uint kPerLine = 2u;
    uint each = max(step, kPerLine);
    uint most = 0u;
    if (kLockstep) {
        for (uint k = first + gl_LocalInvocationID.x * each; k < end; k += gl_WorkGroupSize.x * each) most = max(most, refs.at[k].node);
    }
    return most != kNone;
}
