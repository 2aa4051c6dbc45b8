// Prefix sums over the invocations of a workgroup, of at most kLargestGroup.

#include "lib/meet.glsl"

shared uvec4 groupSums[kLargestGroup];

// The sum of `mine` over the invocations before this one. Called once, by all of them. `lanes` is gl_WorkGroupSize.x; it
// is passed since its value is not known, and taken for 1, where a file is included before the kernel states it.
uvec4 sumBefore(uvec4 mine, uint lanes) {
    uint i = gl_LocalInvocationID.x;
    groupSums[i] = mine;
    meet();
    uvec4 sum = uvec4(0u);
    if (lanes <= 16u) {  // on a CPU barriers cost more than a few loads
        for (uint k = 0u; k < i; k++) sum += groupSums[k];
        return sum;
    }
    sum = mine;
    for (uint step = 1u; step < lanes; step *= 2u) {  // Hillis and Steele 1986
        uvec4 before = i >= step ? groupSums[i - step] : uvec4(0u);
        meet();
        sum += before;
        groupSums[i] = sum;
        meet();
    }
    return sum - mine;
}
