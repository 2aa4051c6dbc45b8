#include "builders/face_scan.h"

#include "builders/lanes.h"

namespace cleave {
namespace {

// The faces of a node's boxes along an axis: all lower ones, then all upper ones, then NaN up to whole vectors.
struct Faces {
    alignas(32) float at[2 * kMostScanned];
    uint32_t flat;  // not 0: there are boxes without extent
};

CLEAVE_INLINE void gather(Faces (&faces)[3], std::span<const ClippedRef> refs) {
    const size_t n = refs.size();
    for (Faces& f : faces) {
        f.flat = 0;
        for (size_t i = 2 * n; i % kLanes != 0; ++i) f.at[i] = std::numeric_limits<float>::quiet_NaN();
    }
    for (size_t i = 0; i < n; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const float lo = refs[i].box.lo[axis], hi = refs[i].box.hi[axis];
            faces[axis].at[i] = lo;
            faces[axis].at[n + i] = hi;
            faces[axis].flat |= lo == hi ? 1u : 0u;
        }
}

CLEAVE_INLINE void scanAlong(LaneBest& best, const Faces& faces, const NodeToSplit& node, uint32_t axis) {
    const size_t n = node.refs.size();
    const AxisCost costs(node.costs, node.cell, axis);
    const Floats none = Floats{} + infinity();
    for (size_t first = 0; first < 2 * n; first += kLanes) {
        const Floats x = loadFloats(faces.at + first);
        Ints left{}, right{};
        for (size_t i = 0; i < n; ++i) {
            left -= faces.at[i] < x;
            right -= faces.at[n + i] > x;
        }
        Floats cost = costs.at(x, left, right);
        Ints planarLeft = Ints{} + 1;
        if (faces.flat != 0) {
            Ints planar{};
            for (size_t i = 0; i < n; ++i) planar -= (faces.at[i] == x) & (faces.at[n + i] == x);
            const Floats costRight = costs.at(x, left, right + planar);
            cost = costs.at(x, left + planar, right);
            planarLeft = cost <= costRight ? planarLeft : Ints{};
            cost = lowest(cost, costRight);
        }
        keepBetter(best, costs.isInside(x) ? cost : none, x, static_cast<int32_t>(axis), planarLeft);
    }
}

}  // namespace

CLEAVE_CLONES Split bestFace(const NodeToSplit& node, uint32_t axes) {
    LaneBest lanes;
    Faces faces[3];
    gather(faces, node.refs);
    for (uint32_t axis = 0; axis < 3; ++axis)
        if ((axes & onlyAxis(axis)) != 0) scanAlong(lanes, faces[axis], node, axis);
    return bestOf(lanes);
}

}  // namespace cleave
