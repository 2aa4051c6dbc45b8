#include "twin/passes.h"

namespace cleave::twin {

namespace {

Split bestBoundary(const BuildArrays& a, const BuildNode& node) {
    const uint32_t step = sampleStep(node.count, a.args.subsample != 0);
    Split best = noSplit();
    for (uint32_t axis = 0; axis < 3; axis++) {
        const BinRange range = rangeOf(a, node.chunk, axis);
        const uint32_t* starts = &a.bins[node.chunk * kBinWords + 2 * axis * kBins];
        const uint32_t* ends = starts + kBins;
        best = betterOf(best, a.args.costs, node.cell, axis, range.lo, 0, node.count, 0);
        best = betterOf(best, a.args.costs, node.cell, axis, range.hi, node.count, 0, 1);
        if (!isResolved(range)) continue;
        for (uint32_t b = 1; b < range.count; b++) {
            uint32_t left = 0;
            uint32_t right = 0;
            for (uint32_t k = 0; k < b; k++) left += starts[k];
            for (uint32_t k = b; k < range.count; k++) right += ends[k];
            best = betterOf(best, a.args.costs, node.cell, axis, binPlane(range, b),
                            estimatedCount(left, step, node.count), estimatedCount(right, step, node.count), 1);
        }
    }
    return best;
}

}  // namespace

void chooseSplit(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        BuildNode& node = a.nodesIn(depth)[a.chunks[c].node];
        if (node.chunk != c) continue;
        const Split best = bestBoundary(a, node);
        const bool keep =
            a.args.snap != 0 || isWorthwhile(a.args.costs, best, node.cell, node.count, depth, a.state.maxDepth);
        node.split = keep ? best : noSplit();
        a.nearest[c] = noFaces();
        std::fill_n(a.bins.begin() + c * kBinWords, kBinWords, 0u);
    }
}

}  // namespace cleave::twin
