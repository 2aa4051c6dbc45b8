// Where to look at a cost that depends on a plane's position, if all positions are too many (Hunt, Mark and Stoll 2006,
// section 3; survey section 6).
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

// A position, and what lies on its two sides: boxes that begin before it, boxes that end behind it.
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

// Where the cost between two neighbouring samples is least, if counts and areas are interpolated linearly.
struct Valley {
    float position;
    float cost;  // half area times count of either side: without the terms that all positions share
};
Valley valleyBetween(const CostSample& a, const CostSample& b, const Box& cell, uint32_t axis);

}  // namespace cleave
