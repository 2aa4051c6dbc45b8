#include "twin/passes.h"

namespace cleave::twin {

void nearest(BuildArrays& a, uint32_t depth) {
    for (uint32_t c = 0; c < a.state.level[depth].chunkCount; c++) {
        const Chunk& chunk = a.chunks[c];
        const BuildNode& node = a.nodesIn(depth)[chunk.node];
        if (node.split.axis == kLeafAxis) continue;
        const int axis = static_cast<int>(node.split.axis);
        NearestFaces& faces = a.nearest[node.chunk];
        for (uint32_t i = chunk.first; i < chunk.first + chunk.count; i++) {
            const PrimRef& r = a.refsIn(depth)[i];
            faces = including(faces, r.lo[axis], r.hi[axis], node.split.position);
        }
    }
}

}  // namespace cleave::twin
