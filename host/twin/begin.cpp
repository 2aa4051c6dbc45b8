#include "twin/passes.h"

namespace cleave::twin {

void begin(BuildArrays& a) {
    const uint32_t n = static_cast<uint32_t>(a.set->included.size());
    const uint32_t chunks = chunksOf(n, a.settings.exactUpTo);
    const uint32_t smalls = smallsOf(n, a.settings.exactUpTo);
    a.nodes[0][0] = buildNode(rootCell(*a.set), 0, n, 0, 0);
    for (uint32_t c = 0; c < chunks; c++) a.chunks[c] = chunkOf(0, 0, n, c);
    if (chunks > 0)
        for (uint32_t k = 0; k < 3; k++) {
            a.bounds[k] = 0xFFFFFFFFu;
            a.bounds[3 + k] = 0;
        }
    if (smalls > 0) a.smallNodes[0] = 0;
    a.state.nodesUsed = 1;
    a.state.level[0] = levelOf(n, 1, chunks, smalls);
}

}  // namespace cleave::twin
