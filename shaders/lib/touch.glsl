// Reads what a workgroup is about to read, a word of each cache line, so that many lines are on their way at a time. CPU
// devices load by address, lane by lane, which their prefetchers do not follow; so a pass over a large level would wait for
// one group of lines after the other. True, always: for the reads to be wanted.
bool touch(PrimRefArray refs, uint first, uint end, uint step) {
    uint least = 0u;
    if (kLockstep) {
        for (uint k = first + gl_LocalInvocationID.x * step; k < end; k += gl_WorkGroupSize.x * step) {
            least = max(least, refs.at[k].node);
        }
    }
    return least != kNone;
}
