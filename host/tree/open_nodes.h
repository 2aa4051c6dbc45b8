// The leaves of a tree that were left open (lazy building): what rays that reach one wait for.
#pragma once

#include <span>
#include <vector>

#include "cleave/cleave.hpp"
#include "tree/kd_tree.h"

namespace cleave {

// In the order of their numbers. `bounds`: of the root; `included`: triangles in the tree, on which the deepest leaf
// depends. `info` is what the nodes were built with.
std::vector<OpenNode> openNodesOf(const Box& bounds, std::span<const KdNode> nodes, uint32_t included,
                                  const BuildInfo& info);

}  // namespace cleave
