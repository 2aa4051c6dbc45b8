// The passes of a breadth-first build, in the order in which they run on a level. Each does to the arrays what the
// kernel of the same name (shaders/build/<name>.comp) does to the device's, bit for bit; `depth` is the level's.
#pragma once

#include "twin/build_arrays.h"

namespace cleave::twin {

void makeRefs(BuildArrays& a);  // once
void begin(BuildArrays& a);     // once

void bounds(BuildArrays& a, uint32_t depth);
void bin(BuildArrays& a, uint32_t depth);
void chooseSplit(BuildArrays& a, uint32_t depth);
void nearest(BuildArrays& a, uint32_t depth);
void snap(BuildArrays& a, uint32_t depth);
void exactSplit(BuildArrays& a, uint32_t depth);
void classify(BuildArrays& a, uint32_t depth);
void scan(BuildArrays& a, uint32_t depth, bool scanNodes);
void offsets(BuildArrays& a, uint32_t depth);
void countChildren(BuildArrays& a, uint32_t depth);
void nextLevel(BuildArrays& a, uint32_t depth);
void emitNodes(BuildArrays& a, uint32_t depth);
void partition(BuildArrays& a, uint32_t depth);

// Shared by the passes: the parts of a node once its references are classified.
struct Children {
    uint32_t left = 0;  // references
    uint32_t right = 0;
};
Children childrenOf(const BuildArrays& a, const BuildNode& node);
// What the node adds to BuildState::nodeTotals.
glm::uvec4 nodeCounts(const BuildArrays& a, const BuildNode& node);
// The range of a large node's bins on one axis.
BinRange rangeOf(const BuildArrays& a, uint32_t chunk, uint32_t axis);

}  // namespace cleave::twin
