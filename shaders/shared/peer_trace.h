// Arguments of the kernels that let the driver answer rays, to compare with.
#ifndef CLEAVE_SHARED_PEER_TRACE_H
#define CLEAVE_SHARED_PEER_TRACE_H
#include "trace.h"

CLEAVE_BEGIN

struct PeerTracePush {
    CLEAVE_ADDRESS(uvec2) scene;  // the top-level acceleration structure
    CLEAVE_ADDRESS(RayArray) rays;
    CLEAVE_ADDRESS(HitArray) hits;  // `prim` counts in the order that the structure was built in
    uint rayCount;
    uint reserved;
};
CLEAVE_SIZE(PeerTracePush, 32);

CLEAVE_END
#endif
