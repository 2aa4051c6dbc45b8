// Bins of exact SAH in large nodes. They count all references, and choose no plane: from the counts at their ends
// follow bounds of what planes cost, so that only bins that may hold the best plane are looked into.
//
// Between two faces of boxes the counts are constant and the cost is affine (survey, section 4).
// From below: a plane in a bin has at least the references on its left that begin before the bin, and on its right
// those that end after it. With these counts the cost is affine in the bin, so the cheaper end of it bounds all planes
// inside. From above: at a boundary of bins the counts are known. Of the last face before it and the first one after it
// one costs no more than the boundary would, with what lies flat in the face on the far side; these must be candidates.
//
// Costs are sums of products of numbers that are not negative, so each is rounded at most ten times in a row, by 2^-24
// of its value, or 2^-23 where a device rounds towards zero. What is flushed to zero adds less than 2^-126 times 4
// areas, 2^30 references and a cost of 1,000. So the margins below are wide.
#ifndef CLEAVE_SHARED_FACE_BINS_H
#define CLEAVE_SHARED_FACE_BINS_H
#include "dispatch.h"
#include "sah.h"

CLEAVE_BEGIN

// The bins of a node on an axis. They span its cell and are as wide as a power of two, so that no device divides.
struct FaceBins {
    float lo;
    float hi;
    float width;
    float scale;  // 1 / width; 0: there is one bin
    uint count;
};

CLEAVE_CONST uint kMostFaceBins = 1u << 15;

// The most bins per axis of a node: a power of two, as many as the counters of its chunks are enough for. So a bin has
// some 64 to 128 faces, if they are spread evenly.
CLEAVE_FN uint faceBinCapacity(uint references) {
    return min(kBins << highestBit(ceilDiv(references, kChunk)), kMostFaceBins);
}

CLEAVE_FN FaceBins faceBins(Box cell, uint axis, uint capacity) {
    FaceBins f;
    f.lo = cell.lo[axis];
    f.hi = cell.hi[axis];
    f.width = 0.0f;
    f.scale = 0.0f;
    f.count = 1u;
    precise float extent = f.hi - f.lo;
    if (!(extent >= kSmallestNormal)) return f;
    // The largest power of two by which the extent stays below the capacity.
    int power = min(int(highestBit(capacity)) - 1 - (int(floatBitsToUint(extent) >> 23) - 127), 126);
    f.scale = uintBitsToFloat(uint(127 + power) << 23);
    f.width = uintBitsToFloat(uint(127 - power) << 23);
    f.count = uint(extent * f.scale) + 1u;
    return f;
}

// Where bin b begins; for `count` the end of the last. Ascends with b.
CLEAVE_FN float faceBinEdge(FaceBins f, uint b) {
    if (b == 0u) return f.lo;
    if (b >= f.count) return f.hi;
    precise float edge = f.lo + f.width * float(b);
    return min(edge, f.hi);
}

// The bin of a face in the cell; ascends with x. The face is not below the bin's edge nor above the next one: the
// difference may be rounded up to the bin's begin, never beyond it, and then comparing puts it right.
CLEAVE_FN uint faceBinOf(FaceBins f, float x) {
    precise float offset = x - f.lo;
    uint b = min(uint(max(offset * f.scale, 0.0f)), f.count - 1u);
    return b > 0u && x < faceBinEdge(f, b) ? b - 1u : b;
}

// Whether the faces on either side of the begin of bin b are candidates; no cell has planes in its own faces. `starts`
// references begin before it, but not in the cell's lower face, and `ends` end after it, but not in its upper one.
CLEAVE_FN bool isBetweenCandidates(FaceBins f, uint b, uint starts, uint ends) {
    float edge = faceBinEdge(f, b);
    return f.lo < edge && edge < f.hi && starts > 0u && ends > 0u;
}

CLEAVE_CONST float kCostMargin = 3.81469727e-6f;      // 2^-18
CLEAVE_CONST float kFlushedMargin = 8.27180613e-25f;  // 2^-80

// Planes in bin b cost at least that. `left` references begin before the bin and `right` end after it.
CLEAVE_FN float leastCost(SahCosts costs, Box cell, uint axis, FaceBins f, uint b, uint left, uint right) {
    float atBegin = splitCost(costs, cell, axis, faceBinEdge(f, b), left, right);
    float atEnd = splitCost(costs, cell, axis, faceBinEdge(f, b + 1u), left, right);
    precise float cost = min(atBegin, atEnd) * (1.0f - kCostMargin);
    cost = cost - kFlushedMargin;
    return cost;
}

// A plane beside the begin of bin b costs at most that. `left` references begin before it and `right` end after it.
CLEAVE_FN float mostCost(SahCosts costs, Box cell, uint axis, FaceBins f, uint b, uint left, uint right) {
    precise float cost = splitCost(costs, cell, axis, faceBinEdge(f, b), left, right) * (1.0f + kCostMargin);
    cost = cost + kFlushedMargin;
    return cost;
}

// Counters are in the words of the node's chunks, in lists of `capacity`: for each axis one of starts and one of ends.
// What lies in the cell's lower face counts as begun and in its upper one as not ended, without being counted.
CLEAVE_FN uint faceWord(uint chunk, uint capacity, uint axis, uint b) {
    return chunk * 6u * kBins + 2u * axis * capacity + b;
}

// What a face is of its reference. A flat one has a single face.
CLEAVE_CONST uint kStartFace = 0u;
CLEAVE_CONST uint kEndFace = 1u;
CLEAVE_CONST uint kFlatFace = 2u;

// So many faces of a bin are compared with each other; more are sorted.
CLEAVE_CONST uint kMostComparedFaces = 256u;

CLEAVE_END
#endif
