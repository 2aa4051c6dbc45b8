#include "twin/build_capacity.h"

#include <algorithm>

#include "base/error.h"

namespace cleave {

namespace {

constexpr uint64_t kMostRefs = kMaxLink;

uint32_t clampRefs(uint64_t n) { return static_cast<uint32_t>(std::min(n, kMostRefs)); }

// Bytes per unit of each capacity, following BuildArgs.
constexpr uint64_t kBytesPerRef = 2 * sizeof(PrimRef) + 2 * sizeof(Box) + 2 * sizeof(uint32_t) + sizeof(glm::uvec2);
constexpr uint64_t kBytesPerLevelNode = 2 * sizeof(BuildNode);
constexpr uint64_t kBytesPerChunk =
    sizeof(Chunk) + sizeof(NearestFaces) + (kBoundsWords + kBinWords) * sizeof(uint32_t);

}  // namespace

BuildCapacity firstCapacity(uint64_t included) {
    BuildCapacity c;
    c.refs = clampRefs(included * 7 / 2 + 4096);
    c.levelNodes = clampRefs(included * 3 / 2 + 4096);
    c.nodes = clampRefs(included * 10 + 4096);
    c.leafRefs = clampRefs(included * 6 + 4096);
    return c;
}

bool overflowed(const BuildState& s) { return s.neededRefs || s.neededLevelNodes || s.neededNodes || s.neededLeafRefs; }

BuildCapacity grownCapacity(const BuildCapacity& capacity, const BuildState& state) {
    // A level that did not fit is not the last: leave room for those that follow.
    auto grown = [](uint32_t had, uint32_t needed) {
        return needed == 0 ? had : clampRefs(std::max<uint64_t>(had, needed) + std::max<uint64_t>(had, needed) / 2);
    };
    BuildCapacity c;
    c.refs = grown(capacity.refs, state.neededRefs);
    c.levelNodes = grown(capacity.levelNodes, state.neededLevelNodes);
    c.nodes = grown(capacity.nodes, state.neededNodes);
    c.leafRefs = grown(capacity.leafRefs, state.neededLeafRefs);
    return c;
}

uint64_t bufferBytes(const BuildCapacity& c, uint32_t exactBelow) {
    return c.refs * kBytesPerRef + c.levelNodes * kBytesPerLevelNode + c.nodes * sizeof(KdNode) +
           c.leafRefs * sizeof(uint32_t) + chunkCapacity(c.refs, exactBelow) * kBytesPerChunk +
           (uint64_t(c.refs) + c.levelNodes) / kBlock * sizeof(glm::uvec4) + sizeof(BuildState);
}

BuildCapacity limitedCapacity(BuildCapacity capacity, uint64_t bytes, uint64_t included, uint32_t exactBelow) {
    if (bytes == 0 || bufferBytes(capacity, exactBelow) <= bytes) return capacity;
    const uint32_t least = clampRefs(std::max<uint64_t>(included, 1));
    BuildCapacity low{least, 1, 1, least};
    if (bufferBytes(low, exactBelow) > bytes)
        throw Error("building over " + std::to_string(included) + " triangles takes at least " +
                    std::to_string(bufferBytes(low, exactBelow)) + " bytes, more than the memory budget; allow more");
    // The largest step between the least and the wanted that fits, all fields alike.
    constexpr uint64_t kSteps = 1024;
    auto between = [&](uint64_t step) {
        auto mix = [&](uint32_t a, uint32_t b) {
            return b <= a ? a : static_cast<uint32_t>(a + (uint64_t(b) - a) * step / kSteps);
        };
        return BuildCapacity{mix(low.refs, capacity.refs), mix(low.levelNodes, capacity.levelNodes),
                             mix(low.nodes, capacity.nodes), mix(low.leafRefs, capacity.leafRefs)};
    };
    uint64_t step = kSteps;
    while (step > 0 && bufferBytes(between(step), exactBelow) > bytes) step--;
    return between(step);
}

Box rootCell(const TriangleSet& set) {
    return set.included.empty() ? Box{glm::vec3(0.0f), glm::vec3(0.0f)} : set.bounds;
}

float inverseBinCount(uint32_t bins) { return 1.0f / static_cast<float>(bins); }

}  // namespace cleave
