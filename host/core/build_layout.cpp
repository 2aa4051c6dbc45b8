#include "core/build_layout.h"

#include <algorithm>
#include <span>

namespace cleave {
namespace {

static_assert(Placement::kMostRanges == BuildSizes::kMostScratch);

uint32_t atMostLink(uint64_t n) { return static_cast<uint32_t>(std::min<uint64_t>(n, kMaxLink)); }

uint64_t ceilDiv64(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

}  // namespace

uint64_t triangleCountOf(const BuildInfo& info) noexcept {
    if (info.list) return info.listCount;
    uint64_t count = 0;
    for (uint32_t i = 0; i < info.geometryCount; i++) count += info.geometries[i].triangleCount;
    return count;
}

Capacity defaultCapacity(uint32_t triangles) noexcept {
    const uint64_t n = triangles;
    return {atMostLink(n * 7 / 4 + 8192), atMostLink(n / 2 + 2048), atMostLink(n * 10 + 4096),
            atMostLink(n * 8 + 4096)};
}

Capacity capacityOf(const BuildInfo& info) noexcept {
    const uint32_t triangles = atMostLink(triangleCountOf(info));
    Capacity c = info.capacity;
    const Capacity normal = defaultCapacity(triangles);
    if (c.refs == 0) c.refs = normal.refs;
    if (c.levelNodes == 0) c.levelNodes = normal.levelNodes;
    if (c.nodes == 0) c.nodes = normal.nodes;
    if (c.leafRefs == 0) c.leafRefs = normal.leafRefs;
    // The root, and with it every triangle, must fit.
    c.refs = std::max({c.refs, triangles, 1u});
    c.leafRefs = std::max({c.leafRefs, triangles, 1u});
    return c;
}

Expansion planExpansion(const BuildInfo& info, uint32_t leafRefs, OpenNode* nodes, uint32_t count) noexcept {
    const Capacity most = capacityOf(info);
    Expansion e;
    uint32_t chunks = 0;
    for (OpenNode& node : std::span(nodes, count)) {
        // The level after this one is likely to have more references, which must fit, too.
        if (e.count > 0 && (e.refs + node.count > most.refs / 2 || e.count == most.levelNodes)) break;
        // And all of them may end in leaves.
        if (uint64_t{leafRefs} + e.refs + node.count > most.leafRefs) break;
        e.count++;
        node.before = e.refs;
        node.chunk = chunks;
        e.refs += node.count;
        e.depth = std::max(e.depth, node.depth);
        chunks += chunksOf(node.count, info.exactUpTo);
    }
    return e;
}

uint32_t openLimit(const BuildInfo& info) noexcept {
    return info.openUpTo == 0 ? 0 : std::max(info.openUpTo, info.exactUpTo);
}

PassChoice choiceOf(const BuildInfo& info, bool expands) noexcept {
    const bool opens = info.openUpTo > 0 && !expands;
    const bool large = info.everything || triangleCountOf(info) > (opens ? openLimit(info) : info.exactUpTo);
    return {large && !info.exact, large && !info.exact && info.snap, large && info.exact, !opens};
}

BuildCounts countsOf(const BuildInfo& info) noexcept {
    const Capacity c = capacityOf(info);
    BuildCounts n;
    n.refs = c.refs;
    n.levelNodes = c.levelNodes;
    n.nodes = c.nodes;
    n.leafRefs = c.leafRefs;
    n.chunks = chunkCapacity(c.refs, info.exactUpTo);
    n.faceChunks = info.exact ? n.chunks : 0;
    n.faces = info.exact ? 6 * n.refs : 0;
    n.refBlocks = ceilDiv64(c.refs, kBlock);
    n.batches = ceilDiv64(c.refs, kBatch);
    n.workers = workersFor(static_cast<uint32_t>(n.batches));
    n.nodeBlocks = ceilDiv64(c.levelNodes, kBlock);
    n.triangles = triangleCountOf(info);
    n.geometries = info.geometryCount;
    return n;
}

ScratchLayout scratchLayout(const BuildCounts& n, uint64_t largestRange) noexcept {
    ScratchLayout l;
    l.ranges = Placement(largestRange);
    l.args = l.ranges.place(sizeof(BuildArgs));
    l.state = l.ranges.place(sizeof(BuildState));
#define CLEAVE_PLACE(name, Element, Array, count) l.name = l.ranges.place((count) * sizeof(Element));
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_PLACE)
#undef CLEAVE_PLACE
    return l;
}

TreeLayout treeLayoutOf(const BuildCounts& n) noexcept {
    return treeLayout(static_cast<uint32_t>(n.triangles), static_cast<uint32_t>(n.nodes),
                      static_cast<uint32_t>(n.leafRefs));
}

GeometryData geometryData(const Geometry& g, uint32_t firstTriangle) noexcept {
    GeometryData d{};
    d.vertices = g.vertices;
    d.indices = g.indices;
    d.transform = g.transform;
    d.stride = static_cast<uint32_t>(g.vertexStride / sizeof(float));
    d.vertexCount = g.vertexCount;
    d.firstTriangle = firstTriangle;
    d.indexBits = g.indexType == VK_INDEX_TYPE_UINT32 ? 32 : g.indexType == VK_INDEX_TYPE_UINT16 ? 16 : 0;
    d.hasTransform = g.transform ? 1 : 0;
    return d;
}

BuildArgs buildArgs(const BuildInfo& info, VkDeviceAddress tree, const Range* scratch, uint32_t row,
                    const Expansion& expansion) noexcept {
    const BuildCounts n = countsOf(info);
    const ScratchLayout at = scratchLayout(n, info.largestRange);
    const auto address = [scratch](const Place& p) { return scratch[p.range].address + p.offset; };
    const TreeLayout parts = treeLayoutOf(n);
    BuildArgs a{};
#define CLEAVE_BIND(name, Element, Array, count) a.name = address(at.name);
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_BIND)
#undef CLEAVE_BIND
    a.triangles = tree + uint64_t(16) * parts.triangles;
    a.tree = tree + uint64_t(16) * parts.nodes;
    a.leafRefs = tree + uint64_t(16) * parts.leafRefs;
    a.state = address(at.state);
    a.header = tree;
    a.list = info.list;
    a.triangleCount = static_cast<uint32_t>(n.triangles);
    a.numberCount = info.list ? a.triangleCount : 0;
    a.geometryCount = info.geometryCount;
    a.refCapacity = static_cast<uint32_t>(n.refs);
    a.levelNodeCapacity = static_cast<uint32_t>(n.levelNodes);
    a.nodeCapacity = static_cast<uint32_t>(n.nodes);
    a.leafRefCapacity = static_cast<uint32_t>(n.leafRefs);
    a.binCount = info.bins;
    a.exactUpTo = expansion.count > 0 || info.openUpTo == 0 ? info.exactUpTo : openLimit(info);
    a.open = expansion.nodes;
    a.openCount = expansion.count;
    a.openRefs = expansion.refs;
    a.openDepth = expansion.depth;
    a.maxDepth = info.maxDepth;
    a.clip = info.clip ? 1 : 0;
    a.subsample = info.subsample ? 1 : 0;
    a.snap = info.snap ? 1 : 0;
    a.row = row;
    a.everything = info.everything ? 1 : 0;
    a.workers = static_cast<uint32_t>(n.workers);
    a.costs = {info.costTraverse, info.costIntersect, info.costLeaf, info.emptyBonus};
    a.invBinCount = 1.0f / static_cast<float>(info.bins);
    return a;
}

BuildSizes buildSizes(const BuildInfo& info) noexcept {
    BuildSizes sizes;
    sizes.alignment = Placement::kAlignment;
    sizes.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT |
                  VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                  VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    if (triangleCountOf(info) > kMaxLink) {
        sizes.failed = "a tree holds at most 2^30 triangles";
        return sizes;
    }
    const BuildCounts n = countsOf(info);
    if (n.faces > kNone) {
        sizes.failed = "an exact build holds at most 2^32 / 6 references";
        return sizes;
    }
    const ScratchLayout scratch = scratchLayout(n, info.largestRange);
    const uint64_t tree = uint64_t(16) * treeLayoutOf(n).end;
    sizes.capacity = capacityOf(info);
    sizes.scratchCount = scratch.ranges.rangeCount();
    for (uint32_t i = 0; i < sizes.scratchCount; i++) sizes.scratch[i] = scratch.ranges.size(i);
    if (scratch.ranges.fits() && (info.largestRange == 0 || tree <= info.largestRange))
        sizes.tree = tree;
    else
        sizes.failed = "an array is larger than the largest range of memory";
    return sizes;
}

}  // namespace cleave
