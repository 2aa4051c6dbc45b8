// How many workgroups, laid out so that every device takes them.
#ifndef CLEAVE_SHARED_DISPATCH_H
#define CLEAVE_SHARED_DISPATCH_H
#include "language.h"

CLEAVE_BEGIN

// As vkCmdDispatchIndirect reads it.
struct DispatchSize {
    uint x;
    uint y;
    uint z;
};
CLEAVE_SIZE(DispatchSize, 12);
CLEAVE_FN uint ceilDiv(uint a, uint b) { return a / b + (a % b != 0u ? 1u : 0u); }

// Vulkan promises 65,535 workgroups per dimension only: more go into rows of at most `row`. See groupIndex() in
// lib/group.glsl.
CLEAVE_CONST uint kLongestRow = 65535u;
CLEAVE_FN DispatchSize dispatchSize(uint groups, uint row) {
    DispatchSize d;
    d.x = min(groups, row);
    d.y = ceilDiv(groups, row);
    d.z = 1u;
    if (groups == 0u) d.y = 0u;
    return d;
}

CLEAVE_END
#endif
