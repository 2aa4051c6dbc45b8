#include "twin/passes.h"

namespace cleave::twin {

void nextLevel(BuildArrays& a, uint32_t depth) {
    BuildState& s = a.state;
    const glm::uvec4 totals = scanBlocks(a.nodeSums, s.level[depth].nodeCount);
    const uint32_t refs = s.refTotals.x + s.refTotals.y;
    const uint32_t levelNodes = 2 * totals.x;
    const uint32_t nodes = s.nodesUsed + levelNodes + s.refTotals.z;
    const uint32_t leafRefs = s.leafRefsUsed + totals.y + s.refTotals.w + refs;
    if (refs > a.args.refCapacity) s.neededRefs = refs;
    if (levelNodes > a.args.levelNodeCapacity) s.neededLevelNodes = levelNodes;
    if (nodes > a.args.nodeCapacity) s.neededNodes = nodes;
    if (leafRefs > a.args.leafRefCapacity) s.neededLeafRefs = leafRefs;
    const bool fits = refs <= a.args.refCapacity && levelNodes <= a.args.levelNodeCapacity &&
                      nodes <= a.args.nodeCapacity && leafRefs <= a.args.leafRefCapacity;
    s.finish = fits ? 0 : 1;
    s.levels = std::max(s.levels, depth + 1);
    s.nodeBase = s.nodesUsed;
    s.leafBase = s.leafRefsUsed;
    s.batchesTaken = 0;
    s.subtreeNodes = s.nodeBase + levelNodes;
    s.subtreeRefs = s.leafBase + totals.y;
    const bool last = depth + 1 >= a.state.maxDepth;  // its nodes are leaves: there is nothing to choose
    s.level[depth + 1] =
        fits ? levelOf(refs, levelNodes, last ? 0 : totals.z, last ? 0 : totals.w, a.args.workers, a.args.row)
             : levelOf(0, 0, 0, 0, 0, a.args.row);
    if (fits) s.nodesUsed = nodes;
    s.leafRefsUsed += fits ? totals.y + s.refTotals.w : s.level[depth].refCount;
}

}  // namespace cleave::twin
