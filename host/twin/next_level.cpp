#include "twin/passes.h"

namespace cleave::twin {

void nextLevel(BuildArrays& a, uint32_t depth) {
    BuildState& s = a.state;
    const uint32_t refs = s.refTotals.x + s.refTotals.y;
    const uint32_t levelNodes = 2 * s.nodeTotals.x;
    const uint32_t nodes = s.nodesUsed + levelNodes;
    const uint32_t leafRefs = s.leafRefsUsed + s.nodeTotals.y + refs;
    if (refs > a.capacity.refs) s.neededRefs = refs;
    if (levelNodes > a.capacity.levelNodes) s.neededLevelNodes = levelNodes;
    if (nodes > a.capacity.nodes) s.neededNodes = nodes;
    if (leafRefs > a.capacity.leafRefs) s.neededLeafRefs = leafRefs;
    const bool fits = refs <= a.capacity.refs && levelNodes <= a.capacity.levelNodes && nodes <= a.capacity.nodes &&
                      leafRefs <= a.capacity.leafRefs;
    s.finish = fits ? 0 : 1;
    s.levels = depth + 1;
    s.nodeBase = s.nodesUsed;
    s.leafBase = s.leafRefsUsed;
    const bool last = depth + 1 >= a.maxDepth;  // its nodes are leaves: there is nothing to choose
    s.level[depth + 1] =
        fits ? levelOf(refs, levelNodes, last ? 0 : s.nodeTotals.z, last ? 0 : s.nodeTotals.w) : levelOf(0, 0, 0, 0);
    if (fits) s.nodesUsed = nodes;
    s.leafRefsUsed += fits ? s.nodeTotals.y : s.level[depth].refCount;
}

}  // namespace cleave::twin
