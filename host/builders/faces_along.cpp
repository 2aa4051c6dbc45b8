#include "builders/faces_along.h"

#include "builders/lanes.h"

namespace cleave {
namespace {

CLEAVE_INLINE float highestOf(Floats x) { return -lowestOf(-x); }

CLEAVE_INLINE int32_t sumOf(Ints x) {
    int32_t sum = 0;
    for (size_t i = 0; i < kLanes; ++i) sum += x[i];
    return sum;
}

struct Around {
    float below, above;  // infinite if there is none
};

CLEAVE_INLINE Around nearestFaces(const FacesAlong& faces, float position) {
    const Floats none = Floats{} + infinity();
    Floats below[2] = {-none, -none}, above[2] = {none, none};
    for (size_t i = 0; i < faces.lo.size(); i += kLanes) {
        const Floats face[2] = {loadFloats(&faces.lo[i]), loadFloats(&faces.hi[i])};
        for (int k = 0; k < 2; ++k) {
            below[k] = highest(below[k], face[k] <= position ? face[k] : -none);
            above[k] = lowest(above[k], face[k] >= position ? face[k] : none);
        }
    }
    return {highestOf(highest(below[0], below[1])), lowestOf(lowest(above[0], above[1]))};
}

// The best of some planes.
template <int count>
CLEAVE_INLINE Split bestOf(const FacesAlong& faces, const NodeToSplit& node, const float (&planes)[count]) {
    Ints left[count] = {}, right[count] = {}, planar[count] = {};
    for (size_t i = 0; i < faces.lo.size(); i += kLanes) {
        const Floats lo = loadFloats(&faces.lo[i]), hi = loadFloats(&faces.hi[i]);
        for (int k = 0; k < count; ++k) {
            left[k] -= lo < planes[k];
            right[k] -= hi > planes[k];
            planar[k] -= (lo == planes[k]) & (hi == planes[k]);
        }
    }
    Split best = noSplit();
    for (int k = 0; k < count; ++k)
        best =
            betterOfBothSides(best, node.costs, node.cell, faces.axis, planes[k], static_cast<uint32_t>(sumOf(left[k])),
                              static_cast<uint32_t>(sumOf(right[k])), static_cast<uint32_t>(sumOf(planar[k])));
    return best;
}

}  // namespace

CLEAVE_CLONES void gatherFaces(FacesAlong& faces, const NodeToSplit& node, uint32_t axis) {
    const size_t n = node.refs.size(), padded = (n + kLanes - 1) / kLanes * kLanes;
    faces.axis = axis;
    faces.lo.resize(padded);
    faces.hi.resize(padded);
    const int a = static_cast<int>(axis);
    for (size_t i = 0; i < n; ++i) {
        faces.lo[i] = node.refs[i].box.lo[a];
        faces.hi[i] = node.refs[i].box.hi[a];
    }
    for (size_t i = n; i < padded; ++i) faces.lo[i] = faces.hi[i] = std::numeric_limits<float>::quiet_NaN();
    Floats from = Floats{} + infinity(), to = -from;
    for (size_t i = 0; i < padded; i += kLanes) {  // NaN is not lower, nor higher
        from = lowest(from, loadFloats(&faces.lo[i]));
        to = highest(to, loadFloats(&faces.hi[i]));
    }
    faces.from = lowestOf(from);
    faces.to = highestOf(to);
}

CLEAVE_CLONES Split bestNear(const FacesAlong& faces, const NodeToSplit& node, float position) {
    const Around around = nearestFaces(faces, position);
    return bestOf<3>(faces, node, {around.below, position, around.above});
}

CLEAVE_CLONES Split bestAt(const FacesAlong& faces, const NodeToSplit& node, float position) {
    return bestOf<1>(faces, node, {position});
}

}  // namespace cleave
