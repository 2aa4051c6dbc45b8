// The faces of a node's boxes along one axis, in plain arrays, for choosers of large nodes.
#pragma once

#include <vector>

#include "builders/adaptive_samples.h"
#include "tree/clipped_ref.h"

namespace cleave {

struct FacesAlong {
    std::vector<float> lo, hi;  // as many as there are references, then NaN up to whole vectors
    uint32_t axis = 0;
    float from = 0.0f, to = 0.0f;  // what all boxes span; from > to if there are none

    BoxExtents extents(const NodeToSplit& node) const {
        return {std::span(lo).first(node.refs.size()), std::span(hi).first(node.refs.size())};
    }
};

void gatherFaces(FacesAlong& faces, const NodeToSplit& node, uint32_t axis);

// The best of the planes at a position and at the nearest faces below and above it, planar references tried on either
// side. Between faces the cost is affine (survey, section 4), so that moving to one of the two never costs more, unless
// that face is the cell's own. No split if none of the three is strictly inside the cell.
Split bestNear(const FacesAlong& faces, const NodeToSplit& node, float position);

// The plane at the position itself, by true counts.
Split bestAt(const FacesAlong& faces, const NodeToSplit& node, float position);

}  // namespace cleave
