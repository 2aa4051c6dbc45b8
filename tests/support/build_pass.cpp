#include "support/build_pass.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "support/device.h"
#include "support/scenes.h"

namespace cleave::test {

namespace {

struct Pass {
    const char* name;
    void (BuildPasses::*onDevice)(Recorder&, const BuildBuffers&, uint32_t) const;
    void (*onTwin)(BuildArrays&, uint32_t);
};

// In the order of a level. The scans are called by what they scan.
const Pass kPasses[] = {
    {"bounds", &BuildPasses::bounds, twin::bounds},
    {"bin", &BuildPasses::bin, twin::bin},
    {"choose_split", &BuildPasses::chooseSplit, twin::chooseSplit},
    {"nearest", &BuildPasses::nearest, twin::nearest},
    {"snap", &BuildPasses::snap, twin::snap},
    {"exact_split", &BuildPasses::exactSplit, twin::exactSplit},
    {"classify", &BuildPasses::classify, twin::classify},
    {"scan", nullptr, [](BuildArrays& a, uint32_t depth) { twin::scan(a, depth, false); }},
    {"offsets", &BuildPasses::offsets, twin::offsets},
    {"count_children", &BuildPasses::countChildren, twin::countChildren},
    {"scan", nullptr, [](BuildArrays& a, uint32_t depth) { twin::scan(a, depth, true); }},
    {"next_level", &BuildPasses::nextLevel, twin::nextLevel},
    {"emit_nodes", &BuildPasses::emitNodes, twin::emitNodes},
    {"partition", &BuildPasses::partition, twin::partition},
};

template <class T>
std::string difference(const char* name, const std::vector<T>& twin, const Buffer& buffer) {
    const std::vector<T> device = buffer.download<T>(twin.size());
    for (size_t i = 0; i < twin.size(); i++) {
        if (std::memcmp(&twin[i], &device[i], sizeof(T)) == 0) continue;
        std::ostringstream text;
        text << name << "[" << i << "] differs; words of twin and device:" << std::hex;
        for (size_t w = 0; w < sizeof(T) / 4; w++) {
            uint32_t a, b;
            std::memcpy(&a, reinterpret_cast<const char*>(&twin[i]) + 4 * w, 4);
            std::memcpy(&b, reinterpret_cast<const char*>(&device[i]) + 4 * w, 4);
            text << " " << a << (a == b ? "=" : "!=") << b;
        }
        return text.str();
    }
    return "";
}

bool isChecked(uint32_t depth, uint32_t maxDepth, uint32_t triangleCount) {
    if (triangleCount < 1000) return true;
    return depth < 2 || depth == maxDepth / 3 || depth == maxDepth / 2 || depth >= maxDepth - 1;
}

}  // namespace

const BuildPasses& buildPasses() {
    static std::unique_ptr<BuildPasses> passes;
    if (!passes) {
        passes = std::make_unique<BuildPasses>(device());
        beforeClose([] { passes.reset(); });
    }
    return *passes;
}

BuildPair::BuildPair(const TriangleSet& set, const BuildSettings& settings)
    : arrays(makeArrays(set, settings, firstCapacity(set.included.size()))),
      buffers(device(), arrays.capacity, settings.exactUpTo),
      passes(buildPasses()),
      triangles_(uploadTriangles(device(), set)) {
    buffers.bind(*triangles_, settings);
}

void BuildPair::upload() {
    for (int parity = 0; parity < 2; parity++) {
        buffers.refs[parity].upload(std::span<const PrimRef>(arrays.refs[parity]));
        buffers.nodes[parity].upload(std::span<const BuildNode>(arrays.nodes[parity]));
    }
    buffers.chunks.upload(std::span<const Chunk>(arrays.chunks));
    buffers.bounds.upload(std::span<const uint32_t>(arrays.bounds));
    buffers.bins.upload(std::span<const uint32_t>(arrays.bins));
    buffers.nearest.upload(std::span<const NearestFaces>(arrays.nearest));
    buffers.smallNodes.upload(std::span<const uint32_t>(arrays.smallNodes));
    buffers.sides.upload(std::span<const uint32_t>(arrays.sides));
    buffers.clipped.upload(std::span<const Box>(arrays.clipped));
    buffers.offsets.upload(std::span<const glm::uvec2>(arrays.offsets));
    buffers.blockSums.upload(std::span<const glm::uvec4>(arrays.blockSums));
    buffers.nodeSums.upload(std::span<const glm::uvec4>(arrays.nodeSums));
    buffers.tree.upload(std::span<const KdNode>(arrays.tree));
    buffers.leafRefs.upload(std::span<const uint32_t>(arrays.leafRefs));
    buffers.state.upload(std::span<const BuildState>(&arrays.state, 1));
}

std::string BuildPair::differenceAfter(const std::function<void(Recorder&)>& onDevice,
                                       const std::function<void()>& onTwin) {
    upload();
    Recorder recorder(device());
    onDevice(recorder);
    recorder.submit();
    onTwin();
    std::string found;
    auto compare = [&](const char* name, const auto& twin, const Buffer& buffer) {
        if (found.empty()) found = difference(name, twin, buffer);
    };
    compare("refs0", arrays.refs[0], buffers.refs[0]);
    compare("refs1", arrays.refs[1], buffers.refs[1]);
    compare("nodes0", arrays.nodes[0], buffers.nodes[0]);
    compare("nodes1", arrays.nodes[1], buffers.nodes[1]);
    compare("chunks", arrays.chunks, buffers.chunks);
    compare("bounds", arrays.bounds, buffers.bounds);
    compare("bins", arrays.bins, buffers.bins);
    compare("nearest", arrays.nearest, buffers.nearest);
    compare("smallNodes", arrays.smallNodes, buffers.smallNodes);
    compare("sides", arrays.sides, buffers.sides);
    compare("clipped", arrays.clipped, buffers.clipped);
    compare("offsets", arrays.offsets, buffers.offsets);
    compare("blockSums", arrays.blockSums, buffers.blockSums);
    compare("nodeSums", arrays.nodeSums, buffers.nodeSums);
    compare("tree", arrays.tree, buffers.tree);
    compare("leafRefs", arrays.leafRefs, buffers.leafRefs);
    compare("state", std::vector<BuildState>{arrays.state}, buffers.state);
    return found;
}

void expectPassEqualsTwin(const std::string& name, uint32_t triangleCount, uint32_t seed) {
    SCOPED_TRACE("triangles " + std::to_string(triangleCount) + ", seed " + std::to_string(seed));
    const TriangleSet set = mixedSet(triangleCount, seed);
    BuildSettings settings;
    settings.clip = seed % 4 != 3;
    settings.subsample = seed % 3 != 0;
    settings.bins = seed % 3 == 2 ? 13 : kBins;
    settings.exactUpTo = seed % 5 == 4 ? 7 : seed % 2 == 1 ? 32 : kExactBelow;
    BuildPair pair(set, settings);
    twin::makeRefs(pair.arrays);
    twin::begin(pair.arrays);
    const uint32_t maxDepth = pair.arrays.maxDepth;
    for (uint32_t depth = 0; depth <= maxDepth && pair.arrays.state.level[depth].nodeCount > 0; depth++) {
        for (size_t p = 0; p < std::size(kPasses); p++) {
            const Pass& pass = kPasses[p];
            auto onTwin = [&] { pass.onTwin(pair.arrays, depth); };
            if (name != pass.name || !isChecked(depth, maxDepth, triangleCount)) {
                onTwin();
                continue;
            }
            const bool scansNodes = p > 7;
            auto onDevice = [&](Recorder& r) {
                if (pass.onDevice)
                    (pair.passes.*pass.onDevice)(r, pair.buffers, depth);
                else
                    pair.passes.scan(r, pair.buffers, depth, scansNodes);
            };
            EXPECT_EQ(pair.differenceAfter(onDevice, onTwin), "") << name << " at depth " << depth;
            if (testing::Test::HasFailure()) return;
        }
    }
}

}  // namespace cleave::test
