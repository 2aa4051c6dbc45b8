// Min-max binning (Shevtsov, Soupikov and Kapustin 2007, section 4.1; survey section 7): the SAH at a few planes per
// axis, from counters of the bins where references start and end. The rules are those of the builder on the device
// (shared/build.h), so that counters agree with the sides that references will go to.
#pragma once

#include "shared/build.h"
#include "tree/clipped_ref.h"

namespace cleave {

// The counters of one node: starts along x, y, z, then ends.
struct Bins {
    BinRange range[3];
    uint32_t counts[6][kMostBins];

    const uint32_t* starts(uint32_t axis) const { return counts[axis]; }
    const uint32_t* ends(uint32_t axis) const { return counts[axis + 3]; }
};

// The bounds of the references' boxes; empty if there are none.
Box boundsOf(std::span<const ClippedRef> refs);

// Counts every `step`-th reference into `bins` bins per axis, 2 to kMostBins, that span `bounds`.
void fillBins(Bins& counted, std::span<const ClippedRef> refs, const Box& bounds, uint32_t bins, uint32_t step);

// The best of the ends of the ranges and of the boundaries between bins. Counters of every `step`-th reference are
// taken times `step`. No split if no plane is strictly inside the cell.
Split bestBoundary(const Bins& counted, const NodeToSplit& node, uint32_t step);

}  // namespace cleave
