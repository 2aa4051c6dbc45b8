// Bins of exact SAH in large nodes. They count all references and choose no plane: they bound what the planes inside
// them can cost, from below and from above, so that only bins that may hold the best plane are looked into.
//
// Every operation of splitCostBetween() is rounded monotonically: the nearer the plane, the smaller a side, the fewer
// references, the lower the cost that comes out, never a bit higher. So with the near end of a bin for either side, and
// with the references that begin before the bin and end after it, the cost is at most that of any plane in the bin, and
// with the far ends and all that begin or end in the bin, too, it is at least that; no margin is needed. The bonus of
// an empty side keeps to that: it is at most 1, and a bound has it where a plane has it (from below), or only there
// (from above).
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

// Whether every face in the bin is a candidate: no cell has planes in its own faces.
CLEAVE_FN bool isInnerBin(FaceBins f, uint b) { return f.lo < faceBinEdge(f, b) && faceBinEdge(f, b + 1u) < f.hi; }

// Bounds of the cost of planes in bin b. `left` references begin before it and `right` end after it,
CLEAVE_FN float leastCost(SahCosts costs, Box cell, uint axis, FaceBins f, uint b, uint left, uint right) {
    return splitCostBetween(costs, cell, axis, faceBinEdge(f, b), faceBinEdge(f, b + 1u), left, right);
}
// or `left` begin before its end, and `right` end after its begin: one of both sides of any plane costs at most that.
CLEAVE_FN float mostCost(SahCosts costs, Box cell, uint axis, FaceBins f, uint b, uint left, uint right) {
    return splitCostBetween(costs, cell, axis, faceBinEdge(f, b + 1u), faceBinEdge(f, b), left, right);
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
