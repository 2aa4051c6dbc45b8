// Checks that a tree is sound: that every ray finds its answer in it. The code shares nothing with the builders.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

struct ValidationReport {
    std::vector<std::string> errors;  // the first few, a sentence each, with node and triangle numbers
    uint64_t errorCount = 0;
    uint64_t surplusReferences = 0;  // listed in a leaf whose closed cell the triangle does not meet: harmless, counted
    bool ok() const { return errorCount == 0; }
};

// Errors: links or leaf ranges out of bounds, shared or unreachable nodes; a plane not strictly inside its cell;
// a leaf deeper than maxDepth; root bounds that do not hold every included triangle; a number that is out of range,
// left out or listed twice in a leaf; a triangle that meets the open interior of a leaf's cell and is not listed there;
// a triangle with a point that lies in no closed cell that lists it.
ValidationReport validate(const KdTree& tree, const TriangleSet& set, uint32_t maxDepth);

}  // namespace cleave
