#include "twin/passes.h"

namespace cleave::twin {

// But for the addresses of the tree's parts, which a twin has not.
void finishTree(BuildArrays& a, uint32_t) {
    const BuildState& s = a.state;
    const BuildArgs& args = a.args;
    const bool isShort = s.neededRefs > 0 || s.neededLevelNodes > 0 || s.neededNodes > 0 || s.neededLeafRefs > 0;
    const bool expands = args.openCount > 0;
    TreeData& t = a.header;
    t.magic = kTreeMagic;
    t.format = kTreeFormatNumber;
    t.status = isShort ? kShortOfCapacity : 0;
    t.levels = expands ? std::max(t.levels, args.openDepth + s.levels) : s.levels;
    t.triangleCount = args.triangleCount;
    t.nodeCount = s.nodesUsed;
    t.leafRefCount = s.leafRefsUsed;
    if (!expands) {
        t.nonFinite = s.scene.nonFinite;
        t.noArea = s.scene.noArea;
        t.exponent = sceneExponent(s.scene.largest);
        t.bounds = rootCell(s.scene);
    }
    t.wantedRefs = s.neededRefs;
    t.wantedLevelNodes = s.neededLevelNodes;
    t.wantedNodes = s.neededNodes;
    t.wantedLeafRefs = s.neededLeafRefs;
    t.bytes = treeBytes(args.triangleCount, s.nodesUsed, s.leafRefsUsed);
    t.wantedBytes = isShort ? treeBytes(args.triangleCount, std::max(args.nodeCapacity, s.neededNodes),
                                        std::max(args.leafRefCapacity, s.neededLeafRefs))
                            : uvec2(0);
}

}  // namespace cleave::twin
