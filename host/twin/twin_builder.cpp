#include "twin/twin_builder.h"

#include "twin/passes.h"

namespace cleave {

namespace {

void buildLevel(BuildArrays& a, uint32_t depth) {
    twin::bounds(a, depth);
    twin::bin(a, depth);
    twin::chooseSplit(a, depth);
    twin::nearest(a, depth);
    twin::snap(a, depth);
    twin::exactSplit(a, depth);
    twin::classify(a, depth);
    twin::scan(a, depth, false);
    twin::offsets(a, depth);
    twin::countChildren(a, depth);
    twin::scan(a, depth, true);
    twin::nextLevel(a, depth);
    twin::emitNodes(a, depth);
    twin::partition(a, depth);
}

}  // namespace

BuildOutcome buildTwin(const TriangleSet& set, const BuildSettings& settings) {
    const uint64_t included = set.included.size();
    BuildCapacity capacity = limitedCapacity(firstCapacity(included), settings.memory, included, settings.exactUpTo);
    while (true) {
        BuildArrays a = makeArrays(set, settings, capacity);
        twin::makeRefs(a);
        twin::begin(a);
        for (uint32_t depth = 0; depth <= a.maxDepth && a.state.level[depth].nodeCount > 0; depth++)
            buildLevel(a, depth);

        const BuildCapacity larger =
            limitedCapacity(grownCapacity(capacity, a.state), settings.memory, included, settings.exactUpTo);
        if (overflowed(a.state) &&
            bufferBytes(larger, settings.exactUpTo) > bufferBytes(capacity, settings.exactUpTo)) {
            capacity = larger;
            continue;
        }
        BuildOutcome result;
        result.peakBytes = bufferBytes(capacity, settings.exactUpTo);
        result.memoryLimited = overflowed(a.state);
        result.tree.bounds = rootCell(set);
        result.tree.exponent = set.exponent;
        a.tree.resize(a.state.nodesUsed);
        a.leafRefs.resize(a.state.leafRefsUsed);
        result.tree.nodes = std::move(a.tree);
        result.tree.leafTriangles = std::move(a.leafRefs);
        return result;
    }
}

}  // namespace cleave
