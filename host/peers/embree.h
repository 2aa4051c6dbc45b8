// Embree, the CPU's ray-tracing kernels by Intel (Wald et al. 2014), where the build has found it.
#pragma once

#include <memory>

#include "peers/peer.h"

namespace cleave {

// Whether Embree is in this build.
bool hasEmbree();

// One ray at a time, as most callers do; its high build quality, which splits triangles in space as a kd-tree does, and
// its robust traversal. `build` times committing the scene. Throws Error; so it does without Embree.
std::unique_ptr<Peer> makeEmbree(const PeerScene& scene);

}  // namespace cleave
