#include <array>

#include "shared/face_bins.h"
#include "twin/passes.h"

namespace cleave::twin {

namespace {

// A bin with faces.
struct Bin {
    uint32_t axis, number;
    uint32_t starts, ends;   // in it
    uint32_t before, after;  // references that begin before it and end after it
};

std::vector<Bin> binsOf(const BuildArrays& a, const BuildNode& node, uint32_t capacity) {
    std::vector<Bin> bins;
    std::array<uint32_t, 3> begun{}, ended{};
    for (uint32_t axis = 0; axis < 3; axis++) {
        const uint32_t* starts = &a.bins[faceWord(node.chunk, capacity, axis, 0)];
        begun[axis] = node.count;
        for (uint32_t b = 0; b < capacity; b++) begun[axis] -= starts[b];
    }
    for (uint32_t b = 0; b < capacity; b++)
        for (uint32_t axis = 0; axis < 3; axis++) {
            const uint32_t* starts = &a.bins[faceWord(node.chunk, capacity, axis, 0)];
            const uint32_t* ends = starts + capacity;
            ended[axis] += ends[b];
            bins.push_back({axis, b, starts[b], ends[b], begun[axis], node.count - ended[axis]});
            begun[axis] += starts[b];
        }
    return bins;
}

// What the best plane costs at most.
float mostOf(const BuildArrays& a, const BuildNode& node, uint32_t capacity, const std::vector<Bin>& bins) {
    if (collapsedAxes(node.cell) >= 2) return -1.0f;
    float most = leafCost(a.args.costs, node.cell, node.count);
    for (const Bin& b : bins) {
        const FaceBins of = faceBins(node.cell, b.axis, capacity);
        if (b.starts + b.ends > 0 && isInnerBin(of, b.number))
            most = std::min(
                most, mostCost(a.args.costs, node.cell, b.axis, of, b.number, b.before + b.starts, b.after + b.ends));
    }
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
        for (const Bin& b : bins) {
            const FaceBins of = faceBins(node.cell, b.axis, capacity);
            const uint32_t starts = faceWord(c, capacity, b.axis, b.number);
            const uint32_t ends = starts + capacity;
            const float least = leastCost(a.args.costs, node.cell, b.axis, of, b.number, b.before, b.after);
            const bool isOpen = b.starts + b.ends > 0 && least <= most;
            a.bins[starts] = b.before;
            a.bins[ends] = b.after;
            a.openBins[starts] = a.openBins[ends] = isOpen ? first : kNone;
            if (isOpen) first += b.starts + b.ends;
        }
    }
}

}  // namespace cleave::twin
