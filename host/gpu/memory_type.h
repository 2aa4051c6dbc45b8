// Which memory a buffer that kernels use lies in, and how the host reaches it.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace cleave {

struct MemoryType {
    uint32_t index = 0;         // into VkPhysicalDeviceMemoryProperties::memoryTypes
    bool mapped = false;        // the host writes to it as to its own memory, and reads a few bytes; else all is staged
    bool cachedByHost = false;  // a mapped one is read that way however much it is
};

// Kernels read and write a buffer many times, the host once, so a buffer lies in the device's own memory, never in the
// host's: there a discrete GPU would fetch every node of a tree over the bus. Of that memory it lies in the largest
// heap, for the window of 256 MiB through which the host sees a GPU without resizable BAR is too small for trees. If
// the heap has a type that the host sees, the buffer is mapped, since writing over the bus is as fast as staging.
// Reading over it is slower by orders of magnitude, a few bytes at a time and each waiting for the one before, unless
// the host's caches serve it, which is so where device and host share their memory; a type which is cached goes first.
//
// `allowed`: the bits of the types that the buffer can have. `maps`: whether mapping is wanted at all. Throws Error if
// no type will do, which Vulkan rules out.
MemoryType memoryTypeFor(const VkPhysicalDeviceMemoryProperties& memory, uint32_t allowed, bool maps);

}  // namespace cleave
