#include "pass/gpu_builder.h"

#include "base/stopwatch.h"
#include "pass/build_passes.h"

namespace cleave {

struct GpuBuilder::Impl {
    explicit Impl(Context& c) : context(c), passes(c) {}
    Context& context;
    BuildPasses passes;
    BuildBuffers buffers;  // kept from build to build

    // Runs a whole build; the state that it ends in.
    BuildState run(const DeviceTriangles& triangles, const BuildSettings& settings) {
        Recorder recorder(context);
        record(recorder, triangles, settings);
        recorder.submit();
        return buffers.state.download<BuildState>(1)[0];
    }

    void record(Recorder& recorder, const DeviceTriangles& triangles, const BuildSettings& settings) {
        buffers.bind(triangles, settings);
        recorder.fillZero(buffers.state);
        passes.makeRefs(recorder, buffers, triangles.includedCount);
        passes.begin(recorder, buffers);
        const uint32_t maxDepth = depthLimit(settings, triangles.includedCount);
        for (uint32_t depth = 0; depth <= maxDepth; depth++) passes.level(recorder, buffers, depth);
    }

    void reserve(const BuildCapacity& c, uint32_t exactBelow) {
        const BuildCapacity& had = buffers.capacity;
        if (had.refs == c.refs && had.levelNodes == c.levelNodes && had.nodes == c.nodes &&
            had.leafRefs == c.leafRefs && buffers.exactBelow == exactBelow)
            return;
        buffers = BuildBuffers();  // frees the old ones first
        buffers = BuildBuffers(context, c, exactBelow);
    }

    // The tree in buffers of just its size.
    std::shared_ptr<DeviceTree> tree(std::shared_ptr<DeviceTriangles> triangles, const BuildState& state) {
        auto tree = std::make_shared<DeviceTree>();
        tree->nodeCount = state.nodesUsed;
        tree->leafRefCount = state.leafRefsUsed;
        tree->bounds = triangles->root;
        tree->exponent = triangles->exponent;
        tree->triangles = std::move(triangles);
        tree->nodes = Buffer(context, tree->nodeCount * sizeof(KdNode));
        tree->leafTriangles = Buffer(context, tree->leafRefCount * sizeof(uint32_t));
        Recorder recorder(context);
        recorder.copy(buffers.tree, tree->nodes, tree->nodes.size());
        recorder.copy(buffers.leafRefs, tree->leafTriangles, tree->leafTriangles.size());
        recorder.submit();
        return tree;
    }
};

GpuBuilder::GpuBuilder(Context& context) : impl_(std::make_unique<Impl>(context)) {}
GpuBuilder::~GpuBuilder() = default;

GpuBuilder::Result GpuBuilder::build(std::shared_ptr<DeviceTriangles> triangles, const BuildSettings& settings) {
    const Stopwatch watch;
    const uint64_t included = triangles->includedCount;
    const uint32_t below = settings.exactUpTo;
    Result result;
    BuildCapacity capacity = limitedCapacity(firstCapacity(included), settings.memory, included, below);
    // Without a limit the tree does not depend on the room, so a build gets what an earlier one needed.
    const BuildCapacity& had = impl_->buffers.capacity;
    if (settings.memory == 0 && had.refs >= capacity.refs && had.levelNodes >= capacity.levelNodes &&
        had.nodes >= capacity.nodes && had.leafRefs >= capacity.leafRefs)
        capacity = had;
    BuildState state{};
    for (result.attempts = 1;; result.attempts++) {
        impl_->reserve(capacity, below);
        state = impl_->run(*triangles, settings);
        result.memoryLimited = overflowed(state);
        const BuildCapacity larger = limitedCapacity(grownCapacity(capacity, state), settings.memory, included, below);
        if (!result.memoryLimited || bufferBytes(larger, below) <= bufferBytes(capacity, below)) break;
        capacity = larger;
    }
    result.tree = impl_->tree(std::move(triangles), state);
    result.levels = state.levels;
    result.peakBytes = impl_->buffers.bytes() + result.tree->nodes.size() + result.tree->leafTriangles.size();
    result.ms = watch.milliseconds();
    return result;
}

std::vector<KernelTime> GpuBuilder::profile(const DeviceTriangles& triangles, const BuildSettings& settings) {
    Recorder recorder(impl_->context, true);
    impl_->record(recorder, triangles, settings);
    recorder.submit();
    return recorder.kernelTimes();
}

void GpuBuilder::warmUp() {
    const Stopwatch watch;
    TriangleSet tiny;
    // Enough overlapping triangles for every kernel to run: some straddle, and there are more than kExactBelow.
    for (uint32_t i = 0; i < 3 * kExactBelow; i++) {
        const float x = static_cast<float>(i) / (3 * kExactBelow);
        tiny.triangles.push_back({{x, 0.0f, 0.0f}, {x + 0.05f, 0.5f, 0.1f}, {x, 0.1f, 0.5f}});
        tiny.included.push_back(i);
    }
    tiny.bounds = Box{{0.0f, 0.0f, 0.0f}, {1.05f, 0.5f, 0.5f}};
    build(uploadTriangles(impl_->context, tiny), BuildSettings{});
    impl_->context.setupMs += watch.milliseconds();
}

}  // namespace cleave
