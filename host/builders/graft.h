// Joins partial trees that were built separately.
#pragma once

#include "tree/kd_tree.h"

namespace cleave {

// Node `at` of the tree becomes the subtree's node 0; the rest of the subtree is appended. Where a depth-first builder
// would have gone on in the tree itself, the result has the same nodes in the same places.
void graft(KdTree& tree, uint32_t at, const KdTree& subtree);

// Appends a pair of children, for the node that will link to it. Throws Error where links have no bits left.
uint32_t appendChildren(KdTree& tree);

// Makes node `at` a leaf, whose list the caller appends next. Throws Error where a leaf cannot point so far.
void beginLeaf(KdTree& tree, uint32_t at, size_t count);

// Peak bytes of a tree that grew by appending: at worst, an array was copied into one of twice its capacity.
uint64_t growthBytes(const KdTree& tree);

}  // namespace cleave
