#include "core/context.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "shared/compact.h"
#include "shared/query.h"
#include "shared/trace.h"

namespace cleave {
namespace {

constexpr uint32_t kMostNarrow = 64;

// Lanes of a workgroup, powers of two up to kLargestGroup. A CPU device runs 8 lanes at once and pays for each barrier
// by the lane. On a GPU a lane per item of a block hides the latency of loads.
struct GroupSizes {
    uint32_t wide = kLargestGroup;
    uint32_t narrow = kMostNarrow;
    bool lockstep = false;  // a workgroup is one vector of a CPU: its lanes need not wait for each other
};

// A CPU device runs the invocations of a subgroup as the lanes of vectors, one instruction of all after the other.
constexpr uint32_t kCpuLanes = 8;

GroupSizes groupSizes(const VkPhysicalDeviceProperties& properties, uint32_t subgroup, uint32_t asked) {
    if (asked != 0) return {asked, std::min(asked, kMostNarrow), false};
    if (properties.deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU) return {};
    return {kCpuLanes, kCpuLanes, subgroup >= kCpuLanes};
}

// Creates kernels and remembers what failed first.
struct Creation {
    const PipelineHome& home;
    NewContext& result;

    bool create(Kernel& kernel, const char* name, size_t pushBytes, std::span<const uint32_t> constants) {
        result.result =
            kernel.create(home, findSpirv(coreKernels(), name), static_cast<uint32_t>(pushBytes), constants);
        if (result.result != VK_SUCCESS) result.failed = name;
        return result.result == VK_SUCCESS;
    }
};

bool createBuildKernels(Creation& creation, Context::State& state, const GroupSizes& sizes, const ContextInfo& info) {
    const auto add = [&](std::span<const BuildPass> passes) {
        for (const BuildPass& pass : passes) {
            const bool known = std::any_of(state.buildKernels.begin(), state.buildKernels.end(),
                                           [&](const Kernel& k) { return k.name() == pass.kernel; });
            if (known || !pass.runs({true, true, info.exactBuilds, true})) continue;
            const uint32_t suited[] = {pass.lanes == Lanes::wide ? sizes.wide : sizes.narrow, sizes.lockstep ? 1u : 0u};
            const std::span<const uint32_t> constants(suited, pass.lanes == Lanes::own ? 0 : 2);
            if (!creation.create(state.buildKernels.emplace_back(), pass.kernel, sizeof(BuildPush), constants))
                return false;
        }
        return true;
    };
    return add(kSetupPasses) && add(kLevelPasses) && add(kLastPasses) && (!info.expands || add(kExpandPasses)) &&
           creation.create(state.compact, "compact", sizeof(CompactPush), {});
}

const char* traceKernelName(const TraceMode& mode) {
    const auto of = [&](const char* plain, const char* instances, const char* lazy) {
        return mode.instances ? instances : mode.lazy ? lazy : plain;
    };
    if (mode.single) return "trace_single";
    switch (mode.traversal) {
        case Traversal::stack:
            return of("trace_stack", "trace_instances_stack", "trace_lazy_stack");
        case Traversal::shortStack:
            return of("trace_short_stack", "trace_instances_short_stack", "trace_lazy_short_stack");
        default:
            return of("trace", "trace_instances", "trace_lazy");
    }
}

bool createTraceKernel(Creation& creation, Kernel& kernel, const TraceMode& mode) {
    if (mode.query == Query::all) return creation.create(kernel, "trace_all", sizeof(TracePush), {});
    if (mode.query == Query::count || mode.query == Query::signedCount) {
        const uint32_t isSigned[] = {mode.query == Query::signedCount ? 1u : 0u};
        return creation.create(kernel, "trace_count", sizeof(TracePush), isSigned);
    }
    const uint32_t constants[] = {mode.query == Query::any ? 1u : 0u, mode.countSteps ? 1u : 0u,
                                  static_cast<uint32_t>(mode.test)};
    return creation.create(kernel, traceKernelName(mode), sizeof(TracePush), constants);
}

bool createTraceKernels(Creation& creation, Context::State& state, std::span<const TraceMode> modes) {
    for (const TraceMode& mode : modes) {
        TraceKernel& made = state.traceKernels.emplace_back();
        made.mode = mode;
        if (!createTraceKernel(creation, made.kernel, mode)) return false;
    }
    return true;
}

bool createSearchKernels(Creation& creation, Context::State& state, std::span<const Search> searches) {
    for (const Search search : searches) {
        const char* name = search == Search::nearest    ? "query_nearest"
                           : search == Search::contains ? "query_contains"
                                                        : "query_overlaps";
        const uint32_t writes[] = {search == Search::listOverlaps ? 1u : 0u};
        const bool overlaps = search == Search::countOverlaps || search == Search::listOverlaps;
        SearchKernel& made = state.searchKernels.emplace_back();
        made.search = search;
        if (!creation.create(made.kernel, name, sizeof(QueryPush), std::span(writes, overlaps ? 1 : 0))) return false;
    }
    return true;
}

const TraceMode kDefaultModes[] = {{Query::closest}, {Query::any}};

void createInto(NewContext& result, Context::State& state, const ContextInfo& info) {
    const auto refuse = [&result](VkResult why, const char* what) {
        result.result = why;
        result.failed = what;
    };
    if (const char* missing = state.functions.load(info.getInstanceProcAddr, info.instance, info.device))
        return refuse(VK_ERROR_INITIALIZATION_FAILED, missing);
    const auto propertiesOf = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties2>(
        info.getInstanceProcAddr(info.instance, "vkGetPhysicalDeviceProperties2"));
    if (!propertiesOf) return refuse(VK_ERROR_INITIALIZATION_FAILED, "vkGetPhysicalDeviceProperties2");
    VkPhysicalDeviceSubgroupProperties subgroups{};
    subgroups.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    VkPhysicalDeviceProperties2 all{};
    all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    all.pNext = &subgroups;
    propertiesOf(info.physicalDevice, &all);
    const VkPhysicalDeviceProperties& properties = all.properties;
    if (properties.limits.maxComputeWorkGroupInvocations < kLargestGroup)
        return refuse(VK_ERROR_FEATURE_NOT_PRESENT, "workgroups of 256 invocations");
    if (info.longestRow != 0) state.row = info.longestRow;
    const PipelineHome home{&state.functions, info.device, info.pipelineCache, info.allocator};
    Creation creation{home, result};
    if (info.builds &&
        !createBuildKernels(creation, state, groupSizes(properties, subgroups.subgroupSize, info.groupLanes), info))
        return;
    const std::span<const TraceMode> modes =
        info.modes ? std::span(info.modes, info.modeCount) : std::span<const TraceMode>(kDefaultModes);
    if (!createTraceKernels(creation, state, modes)) return;
    createSearchKernels(creation, state, std::span(info.searches, info.searchCount));
}

}  // namespace

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::~Context() = default;

NewContext NewContext::create(const ContextInfo& info) noexcept {
    NewContext result;
    try {
        auto state = std::make_unique<Context::State>();
        createInto(result, *state, info);
        if (result.result == VK_SUCCESS) result.context.reset(new Context(std::move(state)));
    } catch (const std::bad_alloc&) {
        result.result = VK_ERROR_OUT_OF_HOST_MEMORY;
        result.failed = "creating a context";
    }
    return result;
}

// A mode or a pass that the context was not created with is a mistake of the caller, for which there is no answer.
const Kernel& Context::State::kernelOf(const BuildPass& pass) const noexcept {
    for (const Kernel& kernel : buildKernels)
        if (kernel.name() == pass.kernel) return kernel;
    std::abort();
}

const Kernel& Context::State::kernelOf(const TraceMode& mode) const noexcept {
    for (const TraceKernel& made : traceKernels)
        if (made.mode == mode) return made.kernel;
    std::abort();
}

const Kernel& Context::State::kernelOf(Search search) const noexcept {
    for (const SearchKernel& made : searchKernels)
        if (made.search == search) return made.kernel;
    std::abort();
}

Requirements requirements() {
    Requirements r{};
    r.apiVersion = VK_API_VERSION_1_3;
    r.features.shaderFloat64 = VK_TRUE;
    r.vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    r.vulkan12.bufferDeviceAddress = VK_TRUE;
    r.vulkan12.scalarBlockLayout = VK_TRUE;
    r.vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    r.vulkan13.synchronization2 = VK_TRUE;
    r.vulkan13.maintenance4 = VK_TRUE;  // workgroup sizes from specialisation constants
    return r;
}

}  // namespace cleave
