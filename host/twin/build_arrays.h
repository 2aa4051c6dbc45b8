// The arrays of a breadth-first build on the CPU: those of shared/build.h's lists.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/build_layout.h"
#include "shared/build.h"

namespace cleave {

// As BuildArgs, but with the arrays themselves.
struct BuildArrays {
    std::vector<Triangle> world;  // what the tree is built over, by number
    std::vector<uint32_t> list;   // ascending numbers of the tree's triangles; empty: all
    std::vector<OpenLeaf> open;   // of an expansion; args tell of them
    BuildArgs args{};             // settings and counts; its addresses are not used
    BuildState state{};
    TreeData header{};
#define CLEAVE_VECTOR(name, Element, Array, count) std::vector<Element> name;
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_VECTOR)
    CLEAVE_TREE_ARRAYS(CLEAVE_VECTOR)
#undef CLEAVE_VECTOR

    // The arrays of references and nodes are double-buffered by the level's parity.
    std::vector<PrimRef>& refsIn(uint32_t depth) { return depth % 2 == 0 ? refs0 : refs1; }
    std::vector<PrimRef>& refsOut(uint32_t depth) { return depth % 2 == 0 ? refs1 : refs0; }
    std::vector<BuildNode>& nodesIn(uint32_t depth) { return depth % 2 == 0 ? nodes0 : nodes1; }
    std::vector<BuildNode>& nodesOut(uint32_t depth) { return depth % 2 == 0 ? nodes1 : nodes0; }
};

// A build of `world` with the settings and the capacity of `info`; geometries and list of that are not looked at.
BuildArrays makeArrays(std::span<const Triangle> world, std::span<const uint32_t> list, BuildInfo info);

// Makes a build that is done, with `info`, one that builds these open nodes of its tree further.
void beginExpansion(BuildArrays& arrays, const BuildInfo& info, std::span<const OpenNode> open);

}  // namespace cleave
