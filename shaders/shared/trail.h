// The restart trail (Laine 2010): which half of each inner node on the way down is being visited. A bit per depth: 0
// while the far child is still to come, 1 once it is being visited or if the node has one child to visit only. A
// traversal that restarts and follows the trail finds its way without a stack, and progress does not depend on t.
#ifndef CLEAVE_SHARED_TRAIL_H
#define CLEAVE_SHARED_TRAIL_H
#include "language.h"

CLEAVE_BEGIN

// Inner nodes have depths 0 to 62 (kMaxDepth is a leaf's): 0 to 31 in `upper`, the others in `lower`; bit d & 31.
struct Trail {
    uint upper;
    uint lower;
};

CLEAVE_FN Trail emptyTrail() {
    Trail t;
    t.upper = 0u;
    t.lower = 0u;
    return t;
}

CLEAVE_FN bool trailBit(Trail t, uint depth) { return ((depth < 32u ? t.upper : t.lower) >> (depth & 31u) & 1u) != 0u; }

CLEAVE_FN Trail withBit(Trail t, uint depth) {
    uint bit = 1u << (depth & 31u);
    if (depth < 32u)
        t.upper |= bit;
    else
        t.lower |= bit;
    return t;
}

// All bits of depths below `depth`, in one word; depth is at most 32.
CLEAVE_FN uint bitsBelow(uint depth) { return depth >= 32u ? 0xFFFFFFFFu : (1u << depth) - 1u; }

// The trail to what comes after a visit that ended at `depth`: the deepest 0 above it becomes 1, what is deeper 0.
// There must be such a 0 (a far child that is still to be visited).
CLEAVE_FN Trail advanced(Trail t, uint depth) {
    uint openLower = depth > 32u ? ~t.lower & bitsBelow(depth - 32u) : 0u;
    if (openLower != 0u) {
        uint bit = highestBit(openLower);
        t.lower = (t.lower & bitsBelow(bit)) | 1u << bit;
        return t;
    }
    uint bit = highestBit(~t.upper & bitsBelow(min(depth, 32u)));
    t.upper = (t.upper & bitsBelow(bit)) | 1u << bit;
    t.lower = 0u;
    return t;
}

CLEAVE_END
#endif
