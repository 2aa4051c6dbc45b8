// What the kernels share that let the driver answer rays.
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/peer_trace.h"

layout(constant_id = 0) const bool kAnyHit = false;
layout(push_constant, scalar) uniform Push { PeerTracePush push; };

const uint kEveryInstance = 0xFFu;
