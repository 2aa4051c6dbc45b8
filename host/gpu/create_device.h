// Vulkan devices with what cleave requires of them.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>

namespace cleave {

// Creates a device with requirements() and one queue of the family, which it returns. `more`: a chain of further
// features, or null. Throws Error, which says `what` failed.
VkQueue createDevice(VkPhysicalDevice physicalDevice, uint32_t queueFamily, std::span<const char* const> extensions,
                     void* more, VkDevice* device, const std::string& what);

}  // namespace cleave
