// The tree over the boxes of all places.
#pragma once

#include <span>
#include <vector>

#include "shared/placed_mesh.h"

namespace cleave {

struct PlaceTree {
    std::vector<PlaceNode> nodes;  // as in a heap, the root first; none without boxes
    std::vector<uint32_t> order;   // the box of each leaf
};

// Halves the boxes by their centres, along the axis where these are spread most.
PlaceTree placeTreeOf(std::span<const Box> boxes);

}  // namespace cleave
