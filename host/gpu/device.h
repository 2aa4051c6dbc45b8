// The opened device, for the code that talks Vulkan. Nothing outside host/gpu and host/pass includes this.
#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "gpu/context.h"

VK_DEFINE_HANDLE(VmaAllocator)

namespace cleave {

// Throws Error naming `what` and the result if it is not VK_SUCCESS.
void check(VkResult result, const char* what);

// Counts and prints what the validation layers say.
struct ValidationLog {
    std::atomic<uint64_t> messages{0};
};

class Context {
  public:
    explicit Context(const std::string& nameOrIndex);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    VkCommandPool commandPool = VK_NULL_HANDLE;
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;
    VmaAllocator allocator = nullptr;
    VkPhysicalDeviceProperties properties{};
    double setupMs = 0.0;
    // Workgroup sizes, specialisation constants of kernels. A CPU device runs 8 lanes at once and pays for each barrier
    // by the lane: its workgroups are as small as that. For kernels whose workgroup treats a block of items:
    uint32_t blockGroup() const { return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 8u : 64u; }
    // And where it treats one small node:
    uint32_t smallGroup() const { return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 8u : 32u; }

    // Outlives the context where somebody wants to know what was said while it closed.
    std::shared_ptr<ValidationLog> validation = std::make_shared<ValidationLog>();

  private:
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    void openDevice(VkPhysicalDevice chosen);
    void loadPipelineCache();
    void savePipelineCache();
    void destroy();
};

}  // namespace cleave
