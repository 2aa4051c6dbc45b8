#include "twin/passes.h"

namespace cleave::twin {

void scan(BuildArrays& a, uint32_t depth, bool scanNodes) {
    const Level& level = a.state.level[depth];
    std::vector<glm::uvec4>& sums = scanNodes ? a.nodeSums : a.blockSums;
    glm::uvec4& total = scanNodes ? a.state.nodeTotals : a.state.refTotals;
    total = glm::uvec4(0);
    for (uint32_t b = 0; b < ceilDiv(scanNodes ? level.nodeCount : level.refCount, kBlock); b++) {
        const glm::uvec4 next = total + sums[b];
        sums[b] = total;
        total = next;
    }
}

}  // namespace cleave::twin
