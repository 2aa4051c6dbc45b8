// Hunt's adaptive sampling: the few plane positions at which to evaluate the SAH (Hunt, Mark and Stoll 2006, section 3;
// survey section 6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/box.h"

namespace cleave {

// The extents of a node's boxes along one axis.
struct BoxExtents {
    std::span<const float> lo;
    std::span<const float> hi;  // of the same length
};

// A plane position, with the numbers of boxes that begin below it (left) and end above it (right).
struct CostSample {
    float position;
    uint32_t left;
    uint32_t right;
};

// Counts at every given position. The loop has no branches and runs over plain arrays, so that it is vectorised.
void countSides(const BoxExtents& boxes, std::span<CostSample> samples);

// Fills `samples` with 2q + 2 ascending ones over [from, to], which holds all boxes: the ends, q uniform ones, and q
// more where left - right grows. Between neighbours, (difference of position) x (difference of left - right) is at
// most (to - from) x 2n / q^2 for n boxes.
void takeAdaptiveSamples(const BoxExtents& boxes, float from, float to, uint32_t q, std::vector<CostSample>& samples);

// The position of least cost between two neighbouring samples, with counts and areas interpolated linearly.
struct Valley {
    float position;
    float cost;  // half area times count of either side: without the terms that all positions share
};
Valley valleyBetween(const CostSample& a, const CostSample& b, const Box& cell, uint32_t axis);

}  // namespace cleave
