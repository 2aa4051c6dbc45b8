#include "run/context_of.h"

#include "gpu/check.h"

namespace cleave {

std::unique_ptr<Context> contextOf(const Device& device, std::span<const TraceMode> modes, Building building,
                                   uint32_t groupLanes, std::span<const Search> searches) {
    static constexpr TraceMode kNone{};  // modes without any are not the default ones
    ContextInfo info;
    info.instance = device.instance();
    info.physicalDevice = device.physicalDevice();
    info.device = device.handle();
    info.getInstanceProcAddr = vkGetInstanceProcAddr;
    info.pipelineCache = device.pipelineCache();
    info.modes = modes.empty() ? &kNone : modes.data();
    info.modeCount = static_cast<uint32_t>(modes.size());
    info.searches = searches.data();
    info.searchCount = static_cast<uint32_t>(searches.size());
    info.builds = building.trees;
    info.exactBuilds = building.exact;
    info.expands = building.open;
    info.longestRow = device.longestRow();
    info.groupLanes = groupLanes;
    NewContext made = createContext(info);
    check(made.result, std::string("creating the pipeline of kernel ") + made.failed);
    return std::move(made.context);
}

}  // namespace cleave
