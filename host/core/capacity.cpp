#include "core/capacity.h"

#include <algorithm>

#include "core/build_layout.h"

namespace cleave {
namespace {

uint64_t bytesWith(BuildInfo info, const Capacity& capacity) {
    info.capacity = capacity;
    return buildBytes(info);
}

}  // namespace

uint64_t buildBytes(const BuildInfo& info) noexcept {
    const BuildCounts n = countsOf(info);
    const ScratchLayout scratch = scratchLayout(n, info.largestRange);
    uint64_t bytes = uint64_t(16) * treeLayoutOf(n).end;
    for (uint32_t i = 0; i < scratch.ranges.rangeCount(); i++) bytes += scratch.ranges.size(i);
    return bytes;
}

std::optional<Capacity> limitedCapacity(const BuildInfo& info, uint64_t bytes) noexcept {
    const Capacity wanted = capacityOf(info);
    if (bytes == 0 || bytesWith(info, wanted) <= bytes) return wanted;
    const auto least = static_cast<uint32_t>(std::max<uint64_t>(triangleCountOf(info), 1));
    const Capacity low{least, 1, 1, least};
    // The largest step between the least and the wanted that fits.
    constexpr uint64_t kSteps = 1024;
    for (uint64_t step = kSteps + 1; step-- > 0;) {
        const auto mix = [step](uint32_t a, uint32_t b) {
            return b <= a ? a : static_cast<uint32_t>(a + (uint64_t(b) - a) * step / kSteps);
        };
        const Capacity between{mix(low.refs, wanted.refs), mix(low.levelNodes, wanted.levelNodes),
                               mix(low.nodes, wanted.nodes), mix(low.leafRefs, wanted.leafRefs)};
        if (bytesWith(info, between) <= bytes) return between;
    }
    return std::nullopt;
}

bool growCapacity(BuildInfo& info, const Capacity& wanted, uint64_t bytes) noexcept {
    const auto grown = [](uint32_t had, uint32_t needed) {
        const uint64_t most = std::max<uint64_t>(had, needed);
        return needed == 0 ? had : static_cast<uint32_t>(std::min<uint64_t>(most + most / 2, kMaxLink));
    };
    const Capacity had = capacityOf(info);
    BuildInfo larger = info;
    larger.capacity = {grown(had.refs, wanted.refs), grown(had.levelNodes, wanted.levelNodes),
                       grown(had.nodes, wanted.nodes), grown(had.leafRefs, wanted.leafRefs)};
    const std::optional<Capacity> limited = limitedCapacity(larger, bytes);
    if (!limited || bytesWith(larger, *limited) <= buildBytes(info)) return false;
    info.capacity = *limited;
    return true;
}

}  // namespace cleave
