// Records a build: arguments and geometries are written, then pass after pass runs. Levels that turn out to be empty
// cost an indirect dispatch of nothing per pass.
#include <array>
#include <cstring>

#include "core/build_layout.h"
#include "core/context.h"
#include "shared/compact.h"

namespace cleave {
namespace {

// In parts, so that nothing is allocated.
void writeGeometries(Recorder& recorder, const BuildInfo& info, VkBuffer buffer, VkDeviceSize at) {
    std::array<GeometryData, 64> part;
    uint32_t firstTriangle = 0;
    for (uint32_t first = 0; first < info.geometryCount; first += static_cast<uint32_t>(part.size())) {
        const uint32_t count = std::min(info.geometryCount - first, static_cast<uint32_t>(part.size()));
        for (uint32_t i = 0; i < count; i++) {
            part[i] = geometryData(info.geometries[first + i], firstTriangle);
            firstTriangle += info.geometries[first + i].triangleCount;
        }
        recorder.write(buffer, at + first * sizeof(GeometryData), part.data(), count * sizeof(GeometryData));
    }
}

class BuildRecording {
  public:
    BuildRecording(const Context::State& state, Recorder& recorder, const BuildInfo& info, const Range* scratch,
                   const ScratchLayout& at)
        : state_(state), recorder_(recorder), info_(info), scratch_(scratch), at_(at) {}

    void arguments(const BuildArgs& args, PassChoice choice) {
        recorder_.write(scratch_[0].buffer, scratch_[0].offset + at_.args.offset, &args, sizeof(args));
        fillZero(at_.state, sizeof(BuildState));
        if (choice.binned) fillZero(at_.bins, countsOf(info_).chunks * kBinWords * sizeof(uint32_t));
        note("arguments");
    }

    // Sized by what the host knows.
    void once(const BuildPass& pass, const Level& level) {
        DispatchSize size{};
        std::memcpy(&size, reinterpret_cast<const char*>(&level) + pass.groups, sizeof(size));
        recorder_.dispatch(state_.kernelOf(pass), push(pass, 0), size);
        note(pass.kernel);
    }
    // Level by level, and what is left to do then.
    void levels(PassChoice choice, uint32_t maxDepth, const Level& input) {
        for (uint32_t depth = 0; depth <= maxDepth; depth++)
            for (const BuildPass& pass : kLevelPasses)
                if (pass.runs(choice)) onLevel(pass, depth);
        for (const BuildPass& pass : kLastPasses) once(pass, input);
    }
    void note(const char* pass) {
        if (info_.onPass) info_.onPass(info_.user, recorder_.commands(), pass);
    }

  private:
    // Sized by what the device knows.
    void onLevel(const BuildPass& pass, uint32_t depth) {
        recorder_.dispatchIndirect(
            state_.kernelOf(pass), push(pass, depth), scratch_[0].buffer,
            scratch_[0].offset + at_.state.offset + offsetof(BuildState, level) + depth * sizeof(Level) + pass.groups);
        note(pass.kernel);
    }
    const Context::State& state_;
    Recorder& recorder_;
    const BuildInfo& info_;
    const Range* scratch_;
    const ScratchLayout& at_;

    void fillZero(const Place& place, uint64_t bytes) {
        const Range& range = scratch_[place.range];
        recorder_.fillZero(range.buffer, range.offset + place.offset, bytes);
    }
    BuildPush push(const BuildPass& pass, uint32_t depth) const {
        return {scratch_[0].address + at_.args.offset, depth, pass.scans};
    }
};

}  // namespace

void cmdBuild(VkCommandBuffer commands, const Context& context, const BuildInfo& info, const Range& tree,
              const Range* scratch) noexcept {
    const Context::State& state = context.state();
    Recorder recorder = state.recorder(commands);
    const BuildArgs args = buildArgs(info, tree.address, scratch, state.row);
    const ScratchLayout at = scratchLayout(countsOf(info), info.largestRange);
    BuildRecording build(state, recorder, info, scratch, at);
    writeGeometries(recorder, info, scratch[0].buffer, scratch[0].offset + at.geometries.offset);
    build.arguments(args, choiceOf(info));
    const Level input = levelOf(args.triangleCount, 1, 0, 0, 0, state.row);
    for (const BuildPass& pass : kSetupPasses) build.once(pass, input);
    build.levels(choiceOf(info), depthLimit(info.maxDepth, args.triangleCount), input);
}

void cmdExpand(VkCommandBuffer commands, const Context& context, const BuildInfo& info, const Expansion& expansion,
               const Range& tree, const Range* scratch) noexcept {
    const Context::State& state = context.state();
    Recorder recorder = state.recorder(commands);
    const BuildArgs args = buildArgs(info, tree.address, scratch, state.row, expansion);
    const ScratchLayout at = scratchLayout(countsOf(info), info.largestRange);
    BuildRecording build(state, recorder, info, scratch, at);
    build.arguments(args, choiceOf(info, true));
    const Level input = levelOf(expansion.refs, expansion.count, 0, 0, 0, state.row);
    for (const BuildPass& pass : kExpandPasses) build.once(pass, input);
    build.levels(choiceOf(info, true), depthLimit(info.maxDepth, args.triangleCount) - expansion.depth, input);
}

namespace {

void copyTree(VkCommandBuffer commands, const Context& context, CompactPush push, const Range& to) noexcept {
    constexpr uint32_t kMostGroups = 4096;  // enough for any device; each invocation copies several entries
    const Context::State& state = context.state();
    const auto entries = to.size / sizeof(KdNode);
    const auto groups = static_cast<uint32_t>(std::min<VkDeviceSize>(entries / kGroup + 1, VkDeviceSize(kMostGroups)));
    push.to = to.address;
    push.invocations = groups * kGroup;
    state.recorder(commands).dispatch(state.compact, push, groups);
}

}  // namespace

void cmdCompact(VkCommandBuffer commands, const Context& context, VkDeviceAddress from, const Range& to) noexcept {
    CompactPush push{};
    push.from = from;
    copyTree(commands, context, push, to);
}

void cmdMove(VkCommandBuffer commands, const Context& context, const BuildInfo& info, VkDeviceAddress from,
             const Range& to) noexcept {
    const Capacity capacity = capacityOf(info);
    CompactPush push{};
    push.from = from;
    push.nodeCapacity = capacity.nodes;
    push.leafRefCapacity = capacity.leafRefs;
    copyTree(commands, context, push, to);
}

}  // namespace cleave
