// The Vulkan device: opened by us, or adopted from somebody who has one.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gpu/instance.h"
#include "gpu/owned.h"
#include "gpu/ray_tracing.h"

VK_DEFINE_HANDLE(VmaAllocator)

namespace cleave {

struct DeviceOptions {
    std::string nameOrIndex;  // see chooseDevice(); empty: the best
    // With it, validation is on (of a device that we open).
    ValidationListener onValidation;
    // Where pipelines are kept from run to run; without these, nowhere. The key names device and driver. What
    // `loadPipelines` returns may be damaged: the driver checks it.
    std::function<std::vector<char>(const std::string& key)> loadPipelines;
    std::function<void(const std::string& key, std::span<const char> data)> storePipelines;
    // False: no device memory is mapped, as on a discrete GPU, and all transfers are staged.
    bool maps = true;
    // False: of mapped memory the host caches nothing, as on a discrete GPU with resizable BAR; long reads are staged.
    bool hostCaches = true;
    uint64_t largestAllocation = 0;          // bytes; 0: what the device says
    size_t stagingBytes = size_t(16) << 20;  // of the ring that transfers go through
    uint32_t longestRow = 0;                 // of workgroups in a dispatch; 0: as long as every device takes
    bool rayTracing = false;                 // opens the driver's own, too, what there is of it
};

// What was moved over the bus: every byte that the host wrote or read in device-visible memory, mapped or staged.
struct TransferCount {
    uint64_t upBytes = 0;
    uint64_t downBytes = 0;
};

class StagingRing;

// Device, queue, memory. One thread uses it at a time.
class Device {
  public:
    struct Adopted {
        VkInstance instance;
        VkPhysicalDevice physicalDevice;
        VkDevice device;  // created with cleave::requirements()
        VkQueue queue;
        uint32_t queueFamily;
    };

    // Opens a device. Throws Error if there is none such.
    explicit Device(DeviceOptions options);
    // Adopts one, which outlives this.
    Device(const Adopted& adopted, DeviceOptions options);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkInstance instance() const { return adopted_.instance; }
    VkPhysicalDevice physicalDevice() const { return adopted_.physicalDevice; }
    VkDevice handle() const { return adopted_.device; }
    VkQueue queue() const { return adopted_.queue; }
    VkCommandPool commandPool() const { return commandPool_.get(); }
    VkPipelineCache pipelineCache() const { return pipelineCache_.get(); }
    VmaAllocator allocator() const { return allocator_.get(); }
    std::string name() const { return properties_.deviceName; }
    const VkPhysicalDeviceProperties& properties() const { return properties_; }
    bool maps() const { return options_.maps; }
    bool hostCaches() const { return options_.hostCaches; }
    uint32_t longestRow() const { return options_.longestRow; }
    // Bytes that one buffer may have.
    uint64_t largestAllocation() const { return largestAllocation_; }
    uint32_t subgroupSize() const { return subgroupSize_; }
    // Ticks of the queue's clock that are valid, as a mask; 0: it has no clock.
    uint64_t clockMask() const { return clockMask_; }

    // What of the driver's own ray tracing is open: nothing unless it was asked for.
    RayTracing rayTracing() const { return rayTracing_; }

    // Bytes of device memory that buffers hold at present.
    uint64_t memoryInUse() const;

    StagingRing& staging();
    TransferCount transfers;  // whoever counts sets it to zero

  private:
    static void destroyDevice(int, VkDevice device, const VkAllocationCallbacks* allocator);
    static void destroyAllocator(int, VmaAllocator allocator, const VkAllocationCallbacks*);

    DeviceOptions options_;
    std::unique_ptr<Instance> instance_;  // of an opened device
    Owned<int, VkDevice, destroyDevice> device_;
    Adopted adopted_{};
    VkPhysicalDeviceProperties properties_{};
    uint64_t largestAllocation_ = 0;
    uint64_t clockMask_ = 0;
    uint32_t subgroupSize_ = 1;
    RayTracing rayTracing_;
    Owned<VkDevice, VkCommandPool, vkDestroyCommandPool> commandPool_;
    Owned<VkDevice, VkPipelineCache, vkDestroyPipelineCache> pipelineCache_;
    Owned<int, VmaAllocator, destroyAllocator> allocator_;
    std::unique_ptr<StagingRing> staging_;

    void open();
    void prepare();
    void createPipelineCache();
    void storePipelineCache();
    std::string pipelineKey() const;
};

}  // namespace cleave
