#include "twin/build_arrays.h"

namespace cleave {

BuildArrays makeArrays(std::span<const Triangle> world, std::span<const uint32_t> list, BuildInfo info) {
    Geometry all;
    all.vertexCount = 3 * static_cast<uint32_t>(world.size());
    all.triangleCount = static_cast<uint32_t>(world.size());
    info.geometries = &all;
    info.geometryCount = 1;
    info.list = list.empty() ? 0 : 1;  // a list that is there; the twin has it itself
    info.listCount = static_cast<uint32_t>(list.size());
    const BuildCounts n = countsOf(info);
    const Range nowhere[BuildSizes::kMostScratch];
    BuildArrays a;
    a.world.assign(world.begin(), world.end());
    a.list.assign(list.begin(), list.end());
    a.args = buildArgs(info, 0, nowhere, kLongestRow);
#define CLEAVE_RESIZE(name, Element, Array, count) a.name.resize(count);
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_RESIZE)
    CLEAVE_TREE_ARRAYS(CLEAVE_RESIZE)
#undef CLEAVE_RESIZE
    return a;
}

void beginExpansion(BuildArrays& arrays, const BuildInfo& info, std::span<const OpenNode> open) {
    std::vector<OpenNode> nodes(open.begin(), open.end());
    const Expansion planned =
        planExpansion(info, arrays.header.leafRefCount, nodes.data(), static_cast<uint32_t>(nodes.size()));
    arrays.state = {};
    arrays.args.exactUpTo = info.exactUpTo;
    arrays.args.openCount = planned.count;
    arrays.args.openRefs = planned.refs;
    arrays.args.openDepth = planned.depth;
    arrays.open.clear();
    for (const OpenNode& n : nodes)
        arrays.open.push_back({{{n.lo[0], n.lo[1], n.lo[2]}, {n.hi[0], n.hi[1], n.hi[2]}},
                               n.node,
                               n.first,
                               n.count,
                               n.depth,
                               n.before,
                               n.chunk});
}

}  // namespace cleave
