// Exclusive prefix sums of a list, in place, by one workgroup.
#include "lib/group_sum.glsl"

// The total, for the last invocation only. An invocation adds up a run of consecutive items by itself. `lanes`: as for
// sumBefore().
uvec4 scanInPlace(Uvec4Array items, uint count, uint lanes) {
    uint run = ceilDiv(count, lanes);
    uint from = min(count, gl_LocalInvocationID.x * run);
    uint to = min(count, from + run);
    uvec4 sum = uvec4(0u);
    for (uint k = from; k < to; k++) sum += items.at[k];
    sum = sumBefore(sum, lanes);
    for (uint k = from; k < to; k++) {
        uvec4 next = items.at[k];
        items.at[k] = sum;
        sum += next;
    }
    return sum;
}
