#include "builders/binning.h"

#include <algorithm>

#include "builders/lanes.h"

namespace cleave {
namespace {

// Of a reference: lo x, y, z, hi x, y, z, and two lanes that mean nothing.
CLEAVE_INLINE Floats facesOf(const ClippedRef& ref) {
    static_assert(offsetof(ClippedRef, box) == 0 && sizeof(Floats) == sizeof(ClippedRef));
    Floats faces;
    std::memcpy(&faces, &ref, sizeof faces);
    return faces;
}

CLEAVE_INLINE Floats perFace(const BinRange (&range)[3], float BinRange::*member) {
    const float x = range[0].*member, y = range[1].*member, z = range[2].*member;
    return Floats{x, y, z, x, y, z, 0.0f, 0.0f};
}

// binIndex (shared/build.h) of the six faces of a reference.
struct BinIndices {
    Floats lo, width, invWidth, last;
    Ints lastBin, resolved, isEnd;

    CLEAVE_INLINE BinIndices(const BinRange (&range)[3])
        : lo(perFace(range, &BinRange::lo)),
          width(perFace(range, &BinRange::width)),
          invWidth(perFace(range, &BinRange::invWidth)),
          last(Floats{} + static_cast<float>(range[0].count - 1)),
          lastBin(Ints{} + static_cast<int32_t>(range[0].count - 1)),
          isEnd{0, 0, 0, -1, -1, -1, 0, 0} {
        const int32_t x = isResolved(range[0]) ? -1 : 0, y = isResolved(range[1]) ? -1 : 0,
                      z = isResolved(range[2]) ? -1 : 0;
        resolved = Ints{x, y, z, x, y, z, 0, 0};
    }

    CLEAVE_INLINE Ints at(Floats face) const {
        const Floats guess = lowest(highest((face - lo) * invWidth, Floats{}), last);
        const Ints bin = __builtin_convertvector(guess, Ints);
        const Floats below = lo + width * __builtin_convertvector(bin, Floats);
        const Floats above = lo + width * __builtin_convertvector(bin + 1, Floats);
        // Ends count strictly, and so do starts of what is flat.
        const Floats other = __builtin_shufflevector(face, face, 3, 4, 5, 0, 1, 2, 6, 7);
        const Ints strictly = isEnd | (face == other);
        const Ints down = (bin > 0) & ((below > face) | (strictly & (below == face)));
        const Ints up = ~down & (bin < lastBin) & ((above < face) | (~strictly & (above == face)));
        return (bin + down - up) & resolved;  // what holds is -1
    }
};

CLEAVE_INLINE void tryBoundaries(LaneBest& best, const Bins& counted, const NodeToSplit& node, uint32_t axis,
                                 uint32_t step) {
    const BinRange& range = counted.range[axis];
    const auto n = static_cast<uint32_t>(node.refs.size());
    alignas(32) uint32_t left[kMostBins + kLanes], right[kMostBins + kLanes];
    uint32_t sum = 0;
    for (uint32_t b = 1; b < range.count; ++b) {
        sum += counted.starts(axis)[b - 1];
        left[b - 1] = estimatedCount(sum, step, n);
    }
    sum = 0;
    for (uint32_t b = range.count - 1; b >= 1; --b) {
        sum += counted.ends(axis)[b];
        right[b - 1] = estimatedCount(sum, step, n);
    }
    const AxisCost costs(node.costs, node.cell, axis);
    const Ints first{1, 2, 3, 4, 5, 6, 7, 8};
    for (uint32_t b = 0; b + 1 < range.count; b += kLanes) {
        const Ints bin = first + static_cast<int32_t>(b);
        const Floats x = range.lo + range.width * __builtin_convertvector(bin, Floats);
        Ints l, r;
        std::memcpy(&l, left + b, sizeof l);
        std::memcpy(&r, right + b, sizeof r);
        const Ints valid = costs.isInside(x) & (bin < static_cast<int32_t>(range.count));
        keepBetter(best, valid ? costs.at(x, l, r) : Floats{} + infinity(), x, static_cast<int32_t>(axis), Ints{} + 1);
    }
}

}  // namespace

CLEAVE_CLONES Box boundsOf(std::span<const ClippedRef> refs) {
    Floats lo = Floats{} + infinity(), hi = Floats{} - infinity();
    for (const ClippedRef& ref : refs) {
        const Floats faces = facesOf(ref);
        lo = lowest(lo, faces);
        hi = highest(hi, faces);
    }
    return {vec3(lo[0], lo[1], lo[2]), vec3(hi[3], hi[4], hi[5])};
}

CLEAVE_CLONES void fillBins(Bins& counted, std::span<const ClippedRef> refs, const Box& bounds, uint32_t bins,
                            uint32_t step) {
    const float inverse = 1.0f / static_cast<float>(bins);
    for (int axis = 0; axis < 3; ++axis)
        counted.range[axis] = binRange(bounds.lo[axis], bounds.hi[axis], bins, inverse);
    for (uint32_t(&row)[kMostBins] : counted.counts) std::memset(row, 0, bins * sizeof row[0]);
    const BinIndices indices(counted.range);
    for (size_t i = 0; i < refs.size(); i += step) {
        const Ints bin = indices.at(facesOf(refs[i]));
        for (size_t row = 0; row < 6; ++row) ++counted.counts[row][bin[row]];
    }
}

CLEAVE_CLONES Split bestBoundary(const Bins& counted, const NodeToSplit& node, uint32_t step) {
    const auto n = static_cast<uint32_t>(node.refs.size());
    LaneBest lanes;
    for (uint32_t axis = 0; axis < 3; ++axis)
        if (isResolved(counted.range[axis])) tryBoundaries(lanes, counted, node, axis, step);
    Split best = bestOf(lanes);
    for (uint32_t axis = 0; axis < 3; ++axis) {
        best = betterOf(best, node.costs, node.cell, axis, counted.range[axis].lo, 0, n, 0);
        best = betterOf(best, node.costs, node.cell, axis, counted.range[axis].hi, n, 0, 1);
    }
    return best;
}

}  // namespace cleave
