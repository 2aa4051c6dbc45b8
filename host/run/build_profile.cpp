#include "run/build_profile.h"

#include <algorithm>
#include <cstring>

#include "core/build_passes.h"

namespace cleave {
namespace {

PassWork& workOf(std::vector<PassWork>& passes, const char* name) {
    const auto known = std::find_if(passes.begin(), passes.end(), [&](const PassWork& p) { return p.name == name; });
    if (known != passes.end()) return *known;
    passes.push_back({name});
    return passes.back();
}

void add(PassWork& work, const BuildPass& pass, const Level& level, double ms) {
    DispatchSize size{};
    std::memcpy(&size, reinterpret_cast<const char*>(&level) + pass.groups, sizeof(size));
    work.ms += ms;
    work.runs += size.x > 0;
    work.workgroups += uint64_t(size.x) * size.y;
    const auto treats = [&](const char* what, uint32_t elements) {
        work.what = what;
        work.elements += elements;
    };
    if (pass.groups == offsetof(Level, perRefBlock)) treats("references", level.refCount);
    if (pass.groups == offsetof(Level, perWorker) || pass.groups == offsetof(Level, perBatch))
        treats("references", level.subtreeRefCount);
    if (pass.groups == offsetof(Level, perChunk) || pass.groups == offsetof(Level, perChunkGroup))
        treats("chunks", level.chunkCount);
    if (pass.groups == offsetof(Level, perNodeBlock)) treats("nodes", level.nodeCount);
}

}  // namespace

BuildProfile profileOf(std::span<const double> ms, const BuildState& state, uint32_t triangles, PassChoice choice) {
    BuildProfile profile;
    profile.nodes = state.nodesUsed;
    size_t next = 0;
    const auto take = [&] { return next < ms.size() ? ms[next++] : 0.0; };
    workOf(profile.passes, "arguments").ms = take();
    const Level input = levelOf(triangles, 1, 0, 0, 0, kLongestRow);
    for (const BuildPass& pass : kSetupPasses) add(workOf(profile.passes, pass.kernel), pass, input, take());
    // A build records as many levels as its triangles can need; the others cost an empty dispatch a pass.
    const auto perLevel =
        static_cast<size_t>(std::count_if(std::begin(kLevelPasses), std::end(kLevelPasses),
                                          [choice](const BuildPass& pass) { return pass.runs(choice); }));
    const size_t recorded = (ms.size() - next - std::size(kLastPasses)) / perLevel;
    for (size_t depth = 0; depth < recorded; depth++) {
        const Level& level = state.level[depth];
        LevelWork sum{level.refCount, level.nodeCount, 0.0};
        for (const BuildPass& pass : kLevelPasses) {
            if (!pass.runs(choice)) continue;
            const double time = take();
            add(workOf(profile.passes, pass.kernel), pass, level, time);
            sum.ms += time;
        }
        if (level.nodeCount > 0) profile.levels.push_back(sum);
    }
    for (const BuildPass& pass : kLastPasses) add(workOf(profile.passes, pass.kernel), pass, input, take());
    return profile;
}

}  // namespace cleave
