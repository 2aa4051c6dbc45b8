#include "gpu/memory_type.h"

#include <algorithm>

#include "base/error.h"

namespace cleave {
namespace {

// Not for buffers of ours, or, AMD's two, so slow that they have to be asked for.
constexpr VkMemoryPropertyFlags kUnfit = VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT | VK_MEMORY_PROPERTY_PROTECTED_BIT |
                                         VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD |
                                         VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD;

}  // namespace

MemoryType memoryTypeFor(const VkPhysicalDeviceMemoryProperties& memory, uint32_t allowed, bool maps) {
    const auto flags = [&](uint32_t type) { return memory.memoryTypes[type].propertyFlags; };
    const auto heapBytes = [&](uint32_t type) { return memory.memoryHeaps[memory.memoryTypes[type].heapIndex].size; };
    const auto fits = [&](uint32_t type) {
        return (allowed >> type & 1) != 0 && (flags(type) & VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT) != 0 &&
               (flags(type) & kUnfit) == 0;
    };
    VkDeviceSize largest = 0;
    for (uint32_t type = 0; type < memory.memoryTypeCount; type++)
        if (fits(type)) largest = std::max(largest, heapBytes(type));

    // Of equals the first: drivers list the faster one before the other.
    MemoryType best;
    int bestRank = -1;
    for (uint32_t type = 0; type < memory.memoryTypeCount; type++) {
        if (!fits(type) || heapBytes(type) < largest) continue;
        const bool mapped = maps && (flags(type) & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0;
        const bool cached = mapped && (flags(type) & VK_MEMORY_PROPERTY_HOST_CACHED_BIT) != 0;
        const int rank = mapped + cached;
        if (rank <= bestRank) continue;
        best = {type, mapped, cached};
        bestRank = rank;
    }
    if (bestRank < 0)
        throw Error("the device offers no memory of its own for a buffer; use another one, see `cleave devices`");
    return best;
}

}  // namespace cleave
