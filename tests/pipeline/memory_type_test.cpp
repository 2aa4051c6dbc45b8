#include "gpu/memory_type.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/error.h"

namespace cleave::test {
namespace {

constexpr VkMemoryPropertyFlags kOwn = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags kSeen = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags kCached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
constexpr VkDeviceSize kMiB = 1 << 20;
constexpr uint32_t kAll = UINT32_MAX;

VkPhysicalDeviceMemoryProperties memoryOf(const std::vector<VkMemoryHeap>& heaps,
                                          const std::vector<VkMemoryType>& types) {
    VkPhysicalDeviceMemoryProperties memory{};
    for (const VkMemoryHeap& heap : heaps) memory.memoryHeaps[memory.memoryHeapCount++] = heap;
    for (const VkMemoryType& type : types) memory.memoryTypes[memory.memoryTypeCount++] = type;
    return memory;
}

const VkMemoryHeap kVideo{81920 * kMiB, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT}, kMain{131072 * kMiB, 0},
    kWindow{246 * kMiB, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};

// As NVIDIA's driver lists them; the window through which the host sees the GPU has a heap of its own, or all is seen.
VkPhysicalDeviceMemoryProperties discrete(bool resizableBar) {
    const std::vector<VkMemoryHeap> heaps{kVideo, kMain, kWindow};
    return memoryOf(resizableBar ? std::vector{kVideo, kMain} : heaps,
                    {{0, 1}, {kOwn, 0}, {kSeen, 1}, {kSeen | kCached, 1}, {kOwn | kSeen, resizableBar ? 0u : 2u}});
}

void expectType(const MemoryType& type, uint32_t index, bool mapped, bool cachedByHost) {
    EXPECT_EQ(type.index, index);
    EXPECT_EQ(type.mapped, mapped);
    EXPECT_EQ(type.cachedByHost, cachedByHost);
}

TEST(MemoryType, LavapipesIsMappedAndCached) {
    const auto memory = memoryOf({{65536 * kMiB, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT}}, {{kOwn | kSeen | kCached, 0}});
    expectType(memoryTypeFor(memory, kAll, true), 0, true, true);
    expectType(memoryTypeFor(memory, kAll, false), 0, false, false);
}

TEST(MemoryType, ADiscreteGpusWindowIsLeftAlone) {
    expectType(memoryTypeFor(discrete(false), kAll, true), 1, false, false);
    expectType(memoryTypeFor(discrete(false), kAll, false), 1, false, false);
}

TEST(MemoryType, WithResizableBarItIsMappedButNotForReading) {
    expectType(memoryTypeFor(discrete(true), kAll, true), 4, true, false);
    expectType(memoryTypeFor(discrete(true), kAll, false), 1, false, false);
}

// A table in which counting the flags that a buffer would like to have ends in the host's memory.
TEST(MemoryType, IsTheDevicesOwnWhereverItIsListed) {
    const auto memory = memoryOf({kMain, kVideo}, {{kSeen, 0}, {kSeen | kCached, 0}, {kOwn, 1}});
    expectType(memoryTypeFor(memory, kAll, true), 2, false, false);
}

TEST(MemoryType, AnIntegratedGpusCachedTypeGoesFirst) {
    const auto memory =
        memoryOf({{16384 * kMiB, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT}},
                 {{kOwn, 0}, {kOwn | kSeen, 0}, {kOwn | kSeen | kCached, 0}, {kOwn | kSeen | kCached, 0}});
    expectType(memoryTypeFor(memory, kAll, true), 2, true, true);
    expectType(memoryTypeFor(memory, kAll, false), 0, false, false);
}

TEST(MemoryType, IsOneThatTheBufferCanHave) {
    expectType(memoryTypeFor(discrete(true), ~(1u << 4), true), 1, false, false);
    EXPECT_THROW(memoryTypeFor(discrete(true), 1u << 2 | 1u << 3, true), Error);
}

TEST(MemoryType, IsNoneThatHasToBeAskedFor) {
    const VkMemoryPropertyFlags uncached =
        VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD | VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD;
    const auto memory = memoryOf(
        {kVideo},
        {{kOwn | VK_MEMORY_PROPERTY_PROTECTED_BIT, 0}, {kOwn | kSeen | kCached | uncached, 0}, {kOwn | kSeen, 0}});
    expectType(memoryTypeFor(memory, kAll, true), 2, true, false);
}

}  // namespace
}  // namespace cleave::test
