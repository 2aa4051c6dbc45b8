// References to triangles, clipped to the cell of a node, and their partition at a plane.
#pragma once

#include <cstring>
#include <span>

#include "shared/clip.h"
#include "shared/sah.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// A reference: a triangle, and the box of its part in the node's cell. One vector register, never across cache lines.
struct alignas(32) ClippedRef {
    Box box;
    uint32_t prim;
};
static_assert(sizeof(ClippedRef) == 32);

// Both may be the same as the source. Whole registers: compilers copy such structures in overlapping pieces, and the
// next read then waits until these have reached the cache.
inline void copyToBoth(const ClippedRef& from, ClippedRef* a, ClippedRef* b) {
    std::byte bytes[sizeof from];
    std::memcpy(bytes, &from, sizeof from);
    std::memcpy(static_cast<void*>(a), bytes, sizeof from);
    std::memcpy(static_cast<void*>(b), bytes, sizeof from);
}

// A node for which a split is to be chosen.
struct NodeToSplit {
    std::span<const ClippedRef> refs;
    Box cell;
    uint32_t depth;
    SahCosts costs = kDefaultCosts;
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

// Where a child's next reference goes.
struct ChildEnds {
    ClippedRef* left;
    ClippedRef* right;
};

// Writes the references of both children, in order, from `ends` on, and moves these. Every reference is written to
// both; an unwanted one is overwritten by the next: each end needs capacity for all references. One of them may be
// where the references themselves are, since reading is always ahead of writing.
inline ChildEnds partition(const TriangleSet& set, std::span<const ClippedRef> refs, const Split& split, bool clip,
                           ChildEnds ends) {
    const int axis = static_cast<int>(split.axis);
    ClippedRef *left = ends.left, *right = ends.right;
    for (const ClippedRef& ref : refs) {
        const uint32_t sides = sideOf(ref.box.lo[axis], ref.box.hi[axis], split.position, split.planarLeft);
        if (sides == (kLeft | kRight)) {
            const uint32_t prim = ref.prim;
            const SplitBoxes parts = splitReference(set, ref, split, clip);
            *left = {parts.left, prim};
            *right = {parts.right, prim};
            left += isEmpty(parts.left) ? 0 : 1;
            right += isEmpty(parts.right) ? 0 : 1;
        } else {
            copyToBoth(ref, left, right);
            left += sides & kLeft;
            right += sides >> 1;
        }
    }
    return {left, right};
}

}  // namespace cleave
