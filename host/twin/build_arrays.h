// What a breadth-first build works on, on the CPU: the arrays of shared/build.h's BuildArgs.
#pragma once

#include <cstdint>
#include <vector>

#include "shared/build.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"
#include "twin/build_capacity.h"

namespace cleave {

// Like BuildArgs, but with the arrays themselves. Arrays of references and nodes are double-buffered by level parity.
struct BuildArrays {
    const TriangleSet* set = nullptr;
    BuildSettings settings;
    BuildCapacity capacity;
    uint32_t maxDepth = 0;

    std::vector<PrimRef> refs[2];
    std::vector<BuildNode> nodes[2];
    std::vector<Chunk> chunks;
    std::vector<uint32_t> bounds;
    std::vector<uint32_t> bins;
    std::vector<NearestFaces> nearest;
    std::vector<uint32_t> smallNodes;
    std::vector<uint32_t> sides;
    std::vector<Box> clipped;
    std::vector<glm::uvec2> offsets;
    std::vector<glm::uvec4> blockSums;
    std::vector<glm::uvec4> nodeSums;
    std::vector<KdNode> tree;
    std::vector<uint32_t> leafRefs;
    BuildState state{};
};

BuildArrays makeArrays(const TriangleSet& set, const BuildSettings& settings, const BuildCapacity& capacity);

}  // namespace cleave
