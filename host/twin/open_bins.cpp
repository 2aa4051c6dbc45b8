#include <numeric>

#include "shared/face_bins.h"
#include "twin/passes.h"

namespace cleave::twin {

namespace {

struct Bin {
    uint32_t axis, number;
    uint32_t starts, ends;  // that are counted in it
    uint32_t left, right;   // references that begin before its begin, and that end after it
    bool isBetweenCandidates;
};

// All of a node, by number, then by axis.
std::vector<Bin> binsOf(const BuildArrays& a, const BuildNode& node, uint32_t capacity) {
    std::vector<Bin> bins(3 * size_t{capacity});
    for (uint32_t axis = 0; axis < 3; axis++) {
        const FaceBins range = faceBins(node.cell, axis, capacity);
        const uint32_t* starts = &a.bins[faceWord(node.chunk, capacity, axis, 0)];
        const uint32_t* ends = starts + capacity;
        const uint32_t allStarts = std::accumulate(starts, ends, 0u);
        uint32_t startsBefore = 0, endsFrom = std::accumulate(ends, ends + capacity, 0u);
        const uint32_t endsInUpperFace = node.count - endsFrom;
        for (uint32_t b = 0; b < capacity; b++) {
            const uint32_t startsInLowerFace = node.count - allStarts;
            bins[3 * b + axis] = {axis,
                                  b,
                                  starts[b],
                                  ends[b],
                                  startsInLowerFace + startsBefore,
                                  endsInUpperFace + endsFrom,
                                  isBetweenCandidates(range, b, startsBefore, endsFrom)};
            startsBefore += starts[b];
            endsFrom -= ends[b];
        }
    }
    return bins;
}

// What the best plane costs at most.
float mostOf(const BuildArrays& a, const BuildNode& node, uint32_t capacity, const std::vector<Bin>& bins) {
    if (collapsedAxes(node.cell) >= 2) return -1.0f;
    float most = leafCost(a.args.costs, node.cell, node.count);
    for (const Bin& b : bins)
        if (b.isBetweenCandidates)
            most = std::min(most, mostCost(a.args.costs, node.cell, b.axis, faceBins(node.cell, b.axis, capacity),
                                           b.number, b.left, b.right));
    return most;
}

}  // namespace

void openBins(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        const BuildNode& node = a.nodesIn(depth)[a.chunks[c].node];
        if (node.chunk != c) continue;
        const uint32_t capacity = faceBinCapacity(node.count);
        const std::vector<Bin> bins = binsOf(a, node, capacity);
        const float most = mostOf(a, node, capacity, bins);
        uint32_t first = 6 * node.first;
        uint32_t* const open = &a.bounds[c * kBoundsWords];
        std::fill_n(open, 3, 0xFFFFFFFFu);
        std::fill_n(open + 3, 3, 0u);
        for (const Bin& b : bins) {
            const FaceBins range = faceBins(node.cell, b.axis, capacity);
            const uint32_t starts = faceWord(c, capacity, b.axis, b.number);
            const uint32_t ends = starts + capacity;
            const float least = leastCost(a.args.costs, node.cell, b.axis, range, b.number, b.left, b.right - b.ends);
            const bool isOpen = b.starts + b.ends > 0 && least <= most;
            a.bins[starts] = b.left;
            a.bins[ends] = b.right - b.ends;
            a.openBins[starts] = a.openBins[ends] = isOpen ? first : kNone;
            if (!isOpen) continue;
            first += b.starts + b.ends;
            open[b.axis] = std::min(open[b.axis], orderedBits(faceBinEdge(range, b.number)));
            open[3 + b.axis] = std::max(open[3 + b.axis], orderedBits(faceBinEdge(range, b.number + 1)));
        }
    }
}

}  // namespace cleave::twin
