#include "twin/passes.h"

namespace cleave::twin {

namespace {

void scan(std::vector<glm::uvec4>& sums, glm::uvec4& total, uint32_t items) {
    total = glm::uvec4(0);
    for (uint32_t b = 0; b < ceilDiv(items, kBlock); b++) {
        const glm::uvec4 next = total + sums[b];
        sums[b] = total;
        total = next;
    }
}

}  // namespace

void scanTriangles(BuildArrays& a, uint32_t) { scan(a.blockSums, a.state.refTotals, a.args.triangleCount); }
void scanRefs(BuildArrays& a, uint32_t depth) { scan(a.blockSums, a.state.refTotals, a.state.level[depth].refCount); }
void scanNodes(BuildArrays& a, uint32_t depth) { scan(a.nodeSums, a.state.nodeTotals, a.state.level[depth].nodeCount); }

}  // namespace cleave::twin
