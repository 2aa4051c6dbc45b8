// What lines meet in a tree, counted by walking it: what the heuristic's expectations are held against.
#pragma once

#include <cstdint>
#include <optional>

#include "shared/ray.h"
#include "tree/kd_tree.h"

namespace cleave {

// What some lines met, added up. A leaf's triangles are tested there, all of them.
struct LineCounts {
    uint64_t lines = 0;
    uint64_t inner = 0, leaves = 0, triangles = 0;

    double perLine(uint64_t count) const;
    // The survey's section 4 for these lines in place of uniformly distributed ones; null without a line.
    std::optional<double> cost(SahCosts costs) const;
};

// Adds the nodes whose cells the ray's part from t = `from` to t = `to` passes through, which is what a walk from front
// to back that ends at `to` visits. The ray is in world space, as its t; `to` may be infinite. A part that passes the
// tree by counts as a line that meets nothing.
void countAlong(const KdTree& tree, const Ray& ray, double from, double to, LineCounts& counts);

}  // namespace cleave
