#include "twin/passes.h"

namespace cleave::twin {

void bounds(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        const Chunk& chunk = a.chunks[c];
        const uint32_t slot = a.nodesIn(depth)[chunk.node].chunk;
        if (c == slot) std::fill_n(a.bins.begin() + slot * kBinWords, kBinWords, 0u);
        for (uint32_t i = chunk.first; i < chunk.first + chunk.count; i++) {
            const PrimRef& r = a.refsIn(depth)[i];
            for (int axis = 0; axis < 3; axis++) {
                uint32_t& lo = a.bounds[slot * kBoundsWords + static_cast<uint32_t>(axis)];
                uint32_t& hi = a.bounds[slot * kBoundsWords + 3 + static_cast<uint32_t>(axis)];
                lo = std::min(lo, orderedBits(r.lo[axis]));
                hi = std::max(hi, orderedBits(r.hi[axis]));
            }
        }
    }
}

BinRange rangeOf(const BuildArrays& a, uint32_t chunk, uint32_t axis) {
    const uint32_t b = chunk * kBoundsWords + axis;
    return binRange(fromOrderedBits(a.bounds[b]), fromOrderedBits(a.bounds[b + 3]), a.args.binCount,
                    a.args.invBinCount);
}

}  // namespace cleave::twin
