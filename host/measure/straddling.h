// Counts the triangles that the planes of a tree cut. Wald and Havran's build runs in O(N log N) if a plane cuts O(sqrt
// n) of a node's n triangles, as is said of reasonable scenes (de Berg et al. 2002; survey section 5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/kd_tree.h"

namespace cleave {

// An inner node: triangles in its leaves, each counted once, and how many of these lie on both sides of its plane.
struct CutNode {
    uint32_t triangles;
    uint32_t straddling;
};

// All inner nodes of a tree, the root last. Takes O(references x depth) steps.
std::vector<CutNode> cutNodes(const KdTree& tree);

// straddling = factor x triangles^exponent, by least squares on logarithms.
struct StraddlingLaw {
    double factor = 0.0;
    double exponent = 0.0;
    uint32_t octaves = 0;  // that it was fitted to; below two there is no law, and the others are 0
};

// Nodes with n triangles, 2^k <= n < 2^(k + 1), are an octave; their means are one point of the fit, so that the few
// large nodes weigh as much as the many small ones. Octaves of fewer than `fewest` triangles, where a plane is chosen
// so that it cuts next to none, and those without a cut triangle are left out.
StraddlingLaw fitStraddling(std::span<const CutNode> nodes, uint32_t fewest = 64);

}  // namespace cleave
