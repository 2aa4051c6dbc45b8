// Where the arrays of a build lie in its two ranges of memory; a function of counts alone.
#pragma once

#include "cleave/cleave.hpp"
#include "core/build_passes.h"
#include "record/placement.h"
#include "shared/build.h"

namespace cleave {

// Entries of the arrays in CLEAVE_SCRATCH_ARRAYS and CLEAVE_TREE_ARRAYS.
struct BuildCounts {
    uint64_t refs = 0;
    uint64_t levelNodes = 0;
    uint64_t nodes = 0;
    uint64_t leafRefs = 0;
    uint64_t chunks = 0;
    uint64_t faceChunks = 0;  // these two: where large nodes are split by exact SAH
    uint64_t faces = 0;
    uint64_t refBlocks = 0;
    uint64_t batches = 0;
    uint64_t workers = 0;
    uint64_t nodeBlocks = 0;
    uint64_t triangles = 0;
    uint64_t geometries = 0;
};

// The triangles of a tree: those of its list, or of all geometries.
uint64_t triangleCountOf(const BuildInfo& info) noexcept;
// info.capacity with the defaults filled in, at least a reference per triangle.
Capacity capacityOf(const BuildInfo& info) noexcept;
BuildCounts countsOf(const BuildInfo& info) noexcept;
// Which passes the build takes, or the expansion of an open tree: with fewer triangles than a large node has references
// there is none.
PassChoice choiceOf(const BuildInfo& info, bool expands = false) noexcept;

// Arguments, state and geometries are always in range 0.
struct ScratchLayout {
    Place args, state;
#define CLEAVE_PLACE_FIELD(name, Element, Array, count) Place name;
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_PLACE_FIELD)
#undef CLEAVE_PLACE_FIELD
    Placement ranges{0};
};
ScratchLayout scratchLayout(const BuildCounts& n, uint64_t largestRange) noexcept;

// Where the tree's arrays begin; the tree itself must not have more than 2^32 blocks (buildSizes() sees to that).
TreeLayout treeLayoutOf(const BuildCounts& n) noexcept;

// A geometry as kernels read it; `firstTriangle` is the number of its first triangle.
GeometryData geometryData(const Geometry& geometry, uint32_t firstTriangle) noexcept;

// The arguments of a build, or of an expansion, as its kernels read them.
BuildArgs buildArgs(const BuildInfo& info, VkDeviceAddress tree, const Range* scratch, uint32_t row,
                    const Expansion& expansion = {}) noexcept;

}  // namespace cleave
