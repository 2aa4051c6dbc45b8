#include "shared/face_bins.h"
#include "twin/passes.h"

namespace cleave::twin {

void countFaces(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        const Chunk& chunk = a.chunks[c];
        const BuildNode& node = a.nodesIn(depth)[chunk.node];
        const uint32_t capacity = faceBinCapacity(node.count);
        for (uint32_t axis = 0; axis < 3; axis++) {
            const int k = static_cast<int>(axis);
            const FaceBins bins = faceBins(node.cell, axis, capacity);
            for (uint32_t i = chunk.first; i < chunk.first + chunk.count; i++) {
                const PrimRef& r = a.refsIn(depth)[i];
                if (r.lo[k] > node.cell.lo[k]) a.bins[faceWord(node.chunk, capacity, axis, faceBinOf(bins, r.lo[k]))]++;
                if (r.hi[k] < node.cell.hi[k])
                    a.bins[faceWord(node.chunk, capacity, axis, faceBinOf(bins, r.hi[k])) + capacity]++;
            }
        }
    }
}

}  // namespace cleave::twin
