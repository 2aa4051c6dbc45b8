#include "twin/passes.h"

namespace cleave::twin {

glm::uvec2 offsetsAt(const BuildArrays& a, uint32_t depth, uint32_t index) {
    if (index == a.state.level[depth].refCount) return {a.state.refTotals.x, a.state.refTotals.y};
    const glm::uvec4& block = a.blockSums[index / kBlock];
    return {block.x + leftBefore(a.sides[index]), block.y + rightBefore(a.sides[index])};
}

Children childrenOf(const BuildArrays& a, uint32_t depth, const BuildNode& node) {
    if (node.split.axis >= kLeafAxis) return {};
    const glm::uvec2 counts = offsetsAt(a, depth, node.first + node.count) - offsetsAt(a, depth, node.first);
    return {counts.x, counts.y};
}

glm::uvec4 nodeCounts(const BuildArrays& a, uint32_t depth, const BuildNode& node) {
    if (node.split.axis == kLeafAxis) return {0, node.count, 0, 0};
    if (node.split.axis == kSubtreeAxis) return glm::uvec4(0);
    const Children c = childrenOf(a, depth, node);
    const uint32_t upTo = a.args.exactUpTo;
    return {1, 0, chunksOf(c.left, upTo) + chunksOf(c.right, upTo),
            subtreeRefsOf(c.left, upTo) + subtreeRefsOf(c.right, upTo)};
}

void countChildren(BuildArrays& a, uint32_t depth) {
    const uint32_t count = a.state.level[depth].nodeCount;
    std::fill_n(a.nodeSums.begin(), ceilDiv(count, kBlock), glm::uvec4(0));
    for (uint32_t n = 0; n < count; n++) a.nodeSums[n / kBlock] += nodeCounts(a, depth, a.nodesIn(depth)[n]);
}

}  // namespace cleave::twin
