// The restart trail (Laine 2010) records which child of each inner node on the current path is being visited. It has a
// bit per depth: 0 while the far child is still to be visited, 1 once it is being visited or where the ray meets only
// one child. A traversal that restarts and follows the trail needs no stack, and its progress does not depend on t.
#ifndef CLEAVE_SHARED_TRAIL_H
#define CLEAVE_SHARED_TRAIL_H
#include "language.h"

CLEAVE_BEGIN

// Inner nodes have depths 0 to 62, since kMaxDepth is that of a leaf. Depth d is bit d & 31 of `upper` if d < 32, else
// of `lower`; so bit 31 of `lower` is free, and marks the ray as finished.
struct Trail {
    uint upper;
    uint lower;
};
CLEAVE_SIZE(Trail, 8);

CLEAVE_FN Trail emptyTrail() {
    Trail t;
    t.upper = 0u;
    t.lower = 0u;
    return t;
}

// Marks a ray that is answered, in place of its trail.
CLEAVE_CONST uint kFinishedBit = 0x80000000u;
CLEAVE_FN Trail finishedTrail() {
    Trail t;
    t.upper = 0u;
    t.lower = kFinishedBit;
    return t;
}
CLEAVE_FN bool isFinished(Trail t) { return (t.lower & kFinishedBit) != 0u; }

CLEAVE_FN bool trailBit(Trail t, uint depth) { return ((depth < 32u ? t.upper : t.lower) >> (depth & 31u) & 1u) != 0u; }

CLEAVE_FN Trail withBit(Trail t, uint depth) {
    uint bit = 1u << (depth & 31u);
    if (depth < 32u)
        t.upper |= bit;
    else
        t.lower |= bit;
    return t;
}

// A word whose bits 0 to depth - 1 are set; depth is at most 32.
CLEAVE_FN uint bitsBelow(uint depth) { return depth >= 32u ? 0xFFFFFFFFu : (1u << depth) - 1u; }

// The depth of the deepest 0 on a path that ended at `depth`. There must be one, that is, a far child that is still to
// be visited.
CLEAVE_FN uint deepestOpen(Trail t, uint depth) {
    uint openLower = depth > 32u ? ~t.lower & bitsBelow(depth - 32u) : 0u;
    if (openLower != 0u) return 32u + highestBit(openLower);
    return highestBit(~t.upper & bitsBelow(min(depth, 32u)));
}

// With a 1 at `depth`, and 0 everywhere deeper.
CLEAVE_FN Trail openedAt(Trail t, uint depth) {
    uint bit = depth & 31u;
    if (depth >= 32u) {
        t.lower = (t.lower & bitsBelow(bit)) | 1u << bit;
        return t;
    }
    t.upper = (t.upper & bitsBelow(bit)) | 1u << bit;
    t.lower = 0u;
    return t;
}

// The trail to the next leaf after a path that ended at `depth`.
CLEAVE_FN Trail advanced(Trail t, uint depth) { return openedAt(t, deepestOpen(t, depth)); }

CLEAVE_END
#endif
