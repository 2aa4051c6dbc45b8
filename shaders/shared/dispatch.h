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

// Vulkan promises 65,535 workgroups per dimension only: more go into rows. See groupIndex() in lib/group.glsl.
CLEAVE_FN DispatchSize dispatchSize(uint groups) {
    DispatchSize d;
    d.x = min(groups, 65535u);
    d.y = ceilDiv(groups, 65535u);
    d.z = 1u;
    if (groups == 0u) d.y = 0u;
    return d;
}

CLEAVE_END
#endif
