#include "twin/build_arrays.h"

namespace cleave {

BuildArrays makeArrays(const TriangleSet& set, const BuildSettings& settings, const BuildCapacity& capacity) {
    BuildArrays a;
    a.set = &set;
    a.settings = settings;
    a.capacity = capacity;
    a.maxDepth = depthLimit(settings, set.included.size());
    const uint32_t chunks = chunkCapacity(capacity.refs, settings.exactUpTo);
    for (int parity = 0; parity < 2; parity++) {
        a.refs[parity].resize(capacity.refs);
        a.nodes[parity].resize(capacity.levelNodes);
    }
    a.chunks.resize(chunks);
    a.bounds.resize(size_t(chunks) * kBoundsWords);
    a.bins.resize(size_t(chunks) * kBinWords);
    a.nearest.resize(chunks);
    a.smallNodes.resize(capacity.refs);
    a.sides.resize(capacity.refs);
    a.clipped.resize(size_t(capacity.refs) * 2);
    a.offsets.resize(size_t(capacity.refs) + 1);
    a.blockSums.resize(ceilDiv(capacity.refs, kBlock));
    a.nodeSums.resize(ceilDiv(capacity.levelNodes, kBlock));
    a.tree.resize(capacity.nodes);
    a.leafRefs.resize(capacity.leafRefs);
    return a;
}

}  // namespace cleave
