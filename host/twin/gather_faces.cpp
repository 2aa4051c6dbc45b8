#include "shared/face_bins.h"
#include "twin/passes.h"

namespace cleave::twin {

void gatherFaces(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        const Chunk& chunk = a.chunks[c];
        const BuildNode& node = a.nodesIn(depth)[chunk.node];
        const uint32_t capacity = faceBinCapacity(node.count);
        const auto put = [&](uint32_t axis, float x, uint32_t kind) {
            if (!isInside(node.cell, axis, x)) return;
            const FaceBins bins = faceBins(node.cell, axis, capacity);
            const uint32_t word = faceWord(node.chunk, capacity, axis, faceBinOf(bins, x));
            if (a.openBins[word] == kNone) return;
            a.workFaces[a.openBins[word + capacity]++] = {floatBitsToUint(x), kind};
        };
        for (uint32_t i = chunk.first; i < chunk.first + chunk.count; i++)
            for (uint32_t axis = 0; axis < 3; axis++) {
                const PrimRef& r = a.refsIn(depth)[i];
                const float lo = r.lo[static_cast<int>(axis)], hi = r.hi[static_cast<int>(axis)];
                put(axis, lo, lo == hi ? kFlatFace : kStartFace);
                if (lo != hi) put(axis, hi, kEndFace);
            }
    }
}

}  // namespace cleave::twin
