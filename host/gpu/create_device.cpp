#include "gpu/create_device.h"

#include "cleave/cleave.hpp"
#include "gpu/check.h"

namespace cleave {

VkQueue createDevice(VkPhysicalDevice physicalDevice, uint32_t queueFamily, std::span<const char* const> extensions,
                     void* more, VkDevice* device, const std::string& what) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queueInfo{};
    queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queueInfo.queueFamilyIndex = queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    Requirements needed = requirements();
    needed.vulkan12.pNext = &needed.vulkan13;
    needed.vulkan13.pNext = more;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &needed.vulkan12;
    features.features = needed.features;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    check(vkCreateDevice(physicalDevice, &info, nullptr, device), what);
    VkQueue queue = VK_NULL_HANDLE;
    vkGetDeviceQueue(*device, queueFamily, 0, &queue);
    return queue;
}

}  // namespace cleave
