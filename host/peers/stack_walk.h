// The textbook way through a kd-tree, in scalar C++: far children wait on a stack.
#pragma once

#include <memory>

#include "peers/peer.h"

namespace cleave {

// Its answers equal those of brute force over the same triangle function, with ==. `build` copies the triangles into
// the order of the leaves, and its time includes the tree's.
std::unique_ptr<Peer> makeStackWalk(const PeerScene& scene);

}  // namespace cleave
