// References of triangles from nodes under construction, and what becomes of those that straddle a plane.
#pragma once

#include <span>

#include "kdtree/kd_tree.h"
#include "kdtree/triangle_set.h"
#include "shared/clip.h"
#include "shared/sah.h"

namespace cleave {

// A reference: a triangle, and the box of its part in the node's cell.
struct ClippedRef {
    Box box;
    uint32_t prim;
};

// What a chooser is asked about.
struct NodeToSplit {
    std::span<const ClippedRef> refs;
    Box cell;
    uint32_t depth;
};

inline ClippedRef wholeTriangle(const TriangleSet& set, uint32_t prim) {
    return {triangleBox(set.triangles[prim]), prim};
}

// The boxes of a straddling reference on either side of a plane; empty where it certainly has no part. Without clipping
// they are the halves of its box. The one clipping of all builders, those on the device included (shared/clip.h).
inline SplitBoxes splitReference(const TriangleSet& set, const ClippedRef& ref, const Split& split, bool clip) {
    if (clip) return splitBoxes(set.triangles[ref.prim], ref.box, split.axis, split.position);
    return {leftOf(ref.box, split.axis, split.position), rightOf(ref.box, split.axis, split.position)};
}

}  // namespace cleave
