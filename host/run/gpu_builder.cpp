#include "run/gpu_builder.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "core/build_layout.h"
#include "core/build_passes.h"
#include "run/context_of.h"
#include "run/device_build.h"
#include "run/ranges.h"
#include "tree/build_info.h"

namespace cleave {
namespace {

// Triangles with these numbers: a geometry for each run of numbers that follow each other, and one without vertices, of
// which the list has none, for what is between them.
std::vector<Geometry> geometriesOf(const DeviceTriangles& triangles, std::span<const uint32_t> numbers) {
    std::vector<Geometry> geometries;
    const auto add = [&](size_t first, size_t vertices, size_t count) {
        Geometry g = triangles.geometry();
        g.vertices += first * sizeof(Triangle);
        g.vertexCount = static_cast<uint32_t>(vertices);
        g.triangleCount = static_cast<uint32_t>(count);
        if (count > 0) geometries.push_back(g);
    };
    uint32_t next = 0;
    for (size_t first = 0, end = 0; first < numbers.size(); first = end) {
        add(0, 0, numbers[first] - next);
        while (end < numbers.size() && numbers[end] - numbers[first] == end - first) end++;
        add(first, 3 * (end - first), end - first);
        next = numbers[end - 1] + 1;
    }
    return geometries;
}

bool contains(const Capacity& a, const Capacity& b) {
    return a.refs >= b.refs && a.levelNodes >= b.levelNodes && a.nodes >= b.nodes && a.leafRefs >= b.leafRefs;
}

constexpr uint32_t kMostStamps =
    (kMaxDepth + 1) * std::size(kLevelPasses) + std::size(kSetupPasses) + std::size(kLastPasses) + 1;

}  // namespace

struct GpuBuilder::State {
    State(Device& d, Building b) : device(d), building(b), context(contextOf(d, {}, b)), commands(d) {}
    Device& device;
    Building building;
    std::shared_ptr<Context> context;
    Commands commands;
    RangeBuffers scratch;  // these are kept from build to build
    RangeBuffers tree;
    Capacity capacity;
    bool isReady = false;       // for builds by default
    bool isReadyExact = false;  // for those with BuildSettings::exact: then the context has their kernels, too

    void addExact() {
        building.exact = true;
        context = contextOf(device, {}, building);
    }

    void reserve(const BuildInfo& info) {
        const BuildSizes sizes = requireSizes(info);
        tree.reserve(device, {&sizes.tree, 1});
        scratch.reserve(device, {sizes.scratch, sizes.scratchCount});
        capacity = sizes.capacity;
    }

    TreeHeader run(Commands& into, const BuildInfo& info) {
        into.begin();
        cmdBuild(into.handle(), *context, info, tree.ranges()[0], scratch.ranges());
        into.run();
        TreeHeader header;
        tree.buffer(0).read(0, &header, sizeof(header));
        return header;
    }

    // The tree in a buffer of just its size.
    std::shared_ptr<DeviceTree> compacted(const TreeHeader& header) {
        auto made = std::make_shared<DeviceTree>();
        made->memory = Buffer(device, header.bytes);
        commands.begin();
        cmdCompact(commands.handle(), *context, tree.buffer(0).address(), rangeOf(made->memory));
        commands.run();
        made->memory.read(0, &made->header, sizeof(made->header));
        return made;
    }
};

GpuBuilder::GpuBuilder(Device& device, bool lazily) {
    const Stopwatch watch;
    state_ = std::make_unique<State>(device, Building{.trees = true, .open = lazily});
    setupMs_ = watch.milliseconds();
    prepare({});
}
GpuBuilder::~GpuBuilder() = default;

void GpuBuilder::prepare(const BuildSettings& settings) {
    bool& isReady = settings.exact ? state_->isReadyExact : state_->isReady;
    if (isReady) return;
    isReady = true;
    const Stopwatch watch;
    if (settings.exact) state_->addExact();
    // Enough overlapping triangles for every kernel to run: some straddle, and there are more than kExactUpTo.
    std::vector<Triangle> tiny;
    for (uint32_t i = 0; i < 3 * kExactUpTo; i++) {
        const float x = static_cast<float>(i) / (3 * kExactUpTo);
        tiny.push_back({{x, 0.0f, 0.0f}, {x + 0.05f, 0.5f, 0.1f}, {x, 0.1f, 0.5f}});
    }
    BuildSettings byDefault;
    byDefault.exact = settings.exact;
    const DeviceTriangles triangles(state_->device, tiny);
    build(triangles, byDefault);
    if (state_->building.open) buildLazily(triangles, byDefault, kExactUpTo)->expandAll();
    setupMs_ += watch.milliseconds();
}

GpuBuilder::Result GpuBuilder::build(const DeviceTriangles& triangles, const BuildSettings& settings,
                                     std::span<const uint32_t> list) {
    const Geometry geometry = triangles.geometry();
    return build({&geometry, 1}, settings, list);
}

GpuBuilder::Result GpuBuilder::buildNumbered(const DeviceTriangles& triangles, const BuildSettings& settings,
                                             std::span<const uint32_t> numbers) {
    return build(geometriesOf(triangles, numbers), settings, numbers);
}

GpuBuilder::Result GpuBuilder::build(std::span<const Geometry> geometries, const BuildSettings& settings,
                                     std::span<const uint32_t> list) {
    prepare(settings);
    const Stopwatch watch;
    State& s = *state_;
    const Buffer numbers = uploaded(s.device, list);
    BuildInfo info = deviceBuildInfo(geometries, settings, s.device);
    if (!list.empty()) {
        info.list = numbers.address();
        info.listCount = static_cast<uint32_t>(list.size());
    }
    info.capacity = requireCapacity(info, settings.memory);
    // Without a limit the tree does not depend on the capacity, so a build gets what an earlier one needed.
    if (settings.memory == 0 && contains(s.capacity, info.capacity)) info.capacity = s.capacity;
    Result result;
    TreeHeader header{};
    for (result.attempts = 1;; result.attempts++) {
        s.reserve(info);
        header = s.run(s.commands, info);
        result.memoryLimited = header.status == TreeHeader::kShortOfCapacity;
        if (!result.memoryLimited || !growCapacity(info, header.wanted, settings.memory)) break;
    }
    result.tree = s.compacted(header);
    result.tree->isOfList = info.listCount > 0;
    result.levels = header.levels;
    result.peakBytes = s.scratch.bytes() + s.tree.bytes() + result.tree->memory.size();
    result.ms = watch.milliseconds();
    return result;
}

std::unique_ptr<LazyTree> GpuBuilder::buildLazily(const DeviceTriangles& triangles, const BuildSettings& settings,
                                                  uint32_t openUpTo, const Capacity& capacity) {
    return std::make_unique<LazyTree>(state_->device, state_->context, triangles, settings, openUpTo, capacity);
}

BuildProfile GpuBuilder::profile(const DeviceTriangles& triangles, const BuildSettings& settings) {
    State& s = *state_;
    const Geometry geometry = triangles.geometry();
    BuildInfo info = deviceBuildInfo({&geometry, 1}, settings, s.device);
    info.capacity = s.capacity;
    s.reserve(info);
    Commands timed(s.device, kMostStamps);
    info.onPass = [](void* user, VkCommandBuffer, const char* pass) { static_cast<Commands*>(user)->stamp(pass); };
    info.user = &timed;
    const TreeHeader header = s.run(timed, info);
    BuildState state;
    const Place& at = scratchLayout(countsOf(info), info.largestRange).state;
    s.scratch.buffer(at.range).read(at.offset, &state, sizeof(state));
    return profileOf(timed.stampMilliseconds(), state, header.triangleCount, choiceOf(info));
}

}  // namespace cleave
