#include "pass/build_buffers.h"

namespace cleave {

BuildBuffers::BuildBuffers(Context& context, const BuildCapacity& room, uint32_t below)
    : capacity(room), exactBelow(below) {
    const size_t words = sizeof(uint32_t);
    const size_t chunkCount = chunkCapacity(room.refs, below);
    for (int parity = 0; parity < 2; parity++) {
        refs[parity] = Buffer(context, room.refs * sizeof(PrimRef));
        nodes[parity] = Buffer(context, room.levelNodes * sizeof(BuildNode));
    }
    chunks = Buffer(context, chunkCount * sizeof(Chunk));
    bounds = Buffer(context, chunkCount * kBoundsWords * words);
    bins = Buffer(context, chunkCount * kBinWords * words);
    nearest = Buffer(context, chunkCount * sizeof(NearestFaces));
    smallNodes = Buffer(context, room.refs * words);
    sides = Buffer(context, room.refs * words);
    clipped = Buffer(context, room.refs * 2 * sizeof(Box));
    offsets = Buffer(context, (size_t(room.refs) + 1) * sizeof(glm::uvec2));
    blockSums = Buffer(context, ceilDiv(room.refs, kBlock) * sizeof(glm::uvec4));
    nodeSums = Buffer(context, ceilDiv(room.levelNodes, kBlock) * sizeof(glm::uvec4));
    tree = Buffer(context, room.nodes * sizeof(KdNode));
    leafRefs = Buffer(context, room.leafRefs * words);
    state = Buffer(context, sizeof(BuildState));
    args = Buffer(context, sizeof(BuildArgs));
}

void BuildBuffers::bind(const DeviceTriangles& triangles, const BuildSettings& settings) {
    BuildArgs a{};
    a.triangles = triangles.triangles.address();
    a.included = triangles.included.address();
    a.refs0 = refs[0].address();
    a.refs1 = refs[1].address();
    a.nodes0 = nodes[0].address();
    a.nodes1 = nodes[1].address();
    a.chunks = chunks.address();
    a.bounds = bounds.address();
    a.bins = bins.address();
    a.nearest = nearest.address();
    a.smallNodes = smallNodes.address();
    a.sides = sides.address();
    a.clipped = clipped.address();
    a.offsets = offsets.address();
    a.blockSums = blockSums.address();
    a.nodeSums = nodeSums.address();
    a.tree = tree.address();
    a.leafRefs = leafRefs.address();
    a.state = state.address();
    a.root = triangles.root;
    a.includedCount = triangles.includedCount;
    a.refCapacity = capacity.refs;
    a.levelNodeCapacity = capacity.levelNodes;
    a.nodeCapacity = capacity.nodes;
    a.leafRefCapacity = capacity.leafRefs;
    a.binCount = settings.bins;
    a.exactBelow = exactBelow;
    a.maxDepth = depthLimit(settings, triangles.includedCount);
    a.clip = settings.clip ? 1 : 0;
    a.subsample = settings.subsample ? 1 : 0;
    a.invBinCount = inverseBinCount(settings.bins);
    args.write(0, &a, sizeof(a));
}

uint64_t BuildBuffers::bytes() const {
    uint64_t sum = 0;
    for (const Buffer* b : {&refs[0], &refs[1], &nodes[0], &nodes[1], &chunks, &bounds, &bins, &nearest, &smallNodes,
                            &sides, &clipped, &offsets, &blockSums, &nodeSums, &tree, &leafRefs, &state, &args})
        sum += b->size();
    return sum;
}

}  // namespace cleave
