#include "twin/passes.h"

namespace cleave::twin {

glm::uvec4 scanBlocks(std::vector<glm::uvec4>& sums, uint32_t items) {
    glm::uvec4 total(0);
    for (uint32_t b = 0; b < ceilDiv(items, kBlock); b++) {
        const glm::uvec4 next = total + sums[b];
        sums[b] = total;
        total = next;
    }
    return total;
}

void scanTriangles(BuildArrays& a, uint32_t) { a.state.refTotals = scanBlocks(a.blockSums, a.args.triangleCount); }
void scanRefs(BuildArrays& a, uint32_t depth) {
    a.state.refTotals = scanBlocks(a.blockSums, a.state.level[depth].refCount);
}

}  // namespace cleave::twin
