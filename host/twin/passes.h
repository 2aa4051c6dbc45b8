// The passes of a build on the CPU, a file each, written to be obvious. Each does to the arrays what the kernel of the
// same name (shaders/build/<name>.comp) does to the device's, bit for bit; `depth` is the level's.
#pragma once

#include <span>

#include "core/build_passes.h"
#include "shared/clip.h"
#include "twin/build_arrays.h"

namespace cleave::twin {

#define CLEAVE_TWIN(kernel, twin, groups, lanes, scans, builds) void twin(BuildArrays& a, uint32_t depth);
CLEAVE_SETUP_PASSES(CLEAVE_TWIN)
CLEAVE_EXPAND_PASSES(CLEAVE_TWIN)
CLEAVE_LEVEL_PASSES(CLEAVE_TWIN)
CLEAVE_LAST_PASSES(CLEAVE_TWIN)
#undef CLEAVE_TWIN

// The rows of the pass table (core/build_passes.h), with their twins.
struct Pass {
    BuildPass row;
    void (*run)(BuildArrays& a, uint32_t depth);
};
std::span<const Pass> setupPasses();
std::span<const Pass> expandPasses();
std::span<const Pass> levelPasses();
std::span<const Pass> lastPasses();
// Runs those of all levels that the first one leads to, and the last ones.
void runLevels(BuildArrays& a, PassChoice choice);

// Shared by the passes: the number of one of the tree's triangles,
uint32_t triangleNumber(const BuildArrays& a, uint32_t index);
// left and right references of the level before one of them, or before its end, once they are classified,
glm::uvec2 offsetsAt(const BuildArrays& a, uint32_t depth, uint32_t index);
// the parts of a node,
struct Children {
    uint32_t left = 0;  // references
    uint32_t right = 0;
};
Children childrenOf(const BuildArrays& a, uint32_t depth, const BuildNode& node);
// what the node adds to the sums of its block,
glm::uvec4 nodeCounts(const BuildArrays& a, uint32_t depth, const BuildNode& node);
// the exclusive prefix sums of the sums of blocks, in place, and their total,
glm::uvec4 scanBlocks(std::vector<glm::uvec4>& sums, uint32_t items);
// the best plane at a face of one of these boxes, by trying them all,
Split bestFace(SahCosts costs, std::span<const PrimRef> refs, Box cell);
// the boxes of a straddling reference on either side of a plane,
SplitBoxes partsOf(const BuildArrays& a, const PrimRef& r, const Split& s);
// the bounds of a large node's references,
void setBounds(BuildArrays& a, uint32_t chunk, Box bounds);
// and the range of its bins on one axis.
BinRange rangeOf(const BuildArrays& a, uint32_t chunk, uint32_t axis);

}  // namespace cleave::twin
