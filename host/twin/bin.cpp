#include "twin/passes.h"

namespace cleave::twin {

BinRange rangeOf(const BuildArrays& a, uint32_t chunk, uint32_t axis) {
    const uint32_t b = chunk * kBoundsWords + axis;
    return binRange(fromOrderedBits(a.bounds[b]), fromOrderedBits(a.bounds[b + 3]), a.args.binCount,
                    a.args.invBinCount);
}

void bin(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        const Chunk& chunk = a.chunks[c];
        const BuildNode& node = a.nodesIn(depth)[chunk.node];
        const uint32_t slot = node.chunk;
        const uint32_t step = sampleStep(node.count, a.args.subsample != 0);
        for (uint32_t axis = 0; axis < 3; axis++) {
            const BinRange range = rangeOf(a, slot, axis);
            if (!isBinned(range, a.args.everything != 0)) continue;
            uint32_t* starts = &a.bins[slot * kBinWords + 2 * axis * kBins];
            uint32_t* ends = starts + kBins;
            for (uint32_t i = chunk.first; i < chunk.first + chunk.count; i++) {
                if ((i - node.first) % step != 0) continue;
                const PrimRef& r = a.refsIn(depth)[i];
                const int k = static_cast<int>(axis);
                starts[startBin(range, r.lo[k], r.hi[k])]++;
                ends[endBin(range, r.hi[k])]++;
            }
        }
    }
}

}  // namespace cleave::twin
