// A tree as bytes, to be kept between runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// Raised whenever the bytes change, or what a tree means to those that walk it.
inline constexpr uint32_t kTreeBytesVersion = 1;

// Little-endian words: "CLVT", the version, the numbers of triangles, nodes and leaf references, the exponent, the root
// cell's bounds, a hash of the triangles (2 words), the nodes (2 words each), the references, and a hash of all before
// it (2 words). `world` is what the tree was built over; it is not kept.
std::vector<std::byte> bytesOfTree(const KdTree& tree, std::span<const Triangle> world);

// The tree again. Throws Error, saying what is wrong, unless the bytes are complete and as they were written, of this
// version and of these triangles, and hold a tree that can be walked: each node is reached once, no deeper than
// kMaxDepth, and all references are in range. `world` is what `set` was made of.
KdTree treeOfBytes(std::span<const std::byte> bytes, std::span<const Triangle> world, const TriangleSet& set);

}  // namespace cleave
