#include "gpu/device.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "cleave/cleave.hpp"
#include "gpu/allocator.h"
#include "gpu/check.h"
#include "gpu/create_device.h"
#include "gpu/staging.h"

namespace cleave {

void Device::destroyDevice(int, VkDevice device, const VkAllocationCallbacks* allocator) {
    vkDestroyDevice(device, allocator);
}

void Device::destroyAllocator(int, VmaAllocator allocator, const VkAllocationCallbacks*) {
    vmaDestroyAllocator(allocator);
}

Device::Device(DeviceOptions options) : options_(std::move(options)) {
    instance_ = std::make_unique<Instance>(options_.onValidation);
    open();
    prepare();
}

Device::Device(const Adopted& adopted, DeviceOptions options) : options_(std::move(options)), adopted_(adopted) {
    prepare();
}

Device::~Device() {
    if (handle()) vkDeviceWaitIdle(handle());
    storePipelineCache();
}

void Device::open() {
    const std::vector<VkPhysicalDevice> devices = instance_->devices();
    std::vector<DeviceInfo> infos;
    for (VkPhysicalDevice d : devices) infos.push_back(describe(d, static_cast<uint32_t>(infos.size())));
    adopted_.instance = instance_->handle();
    adopted_.physicalDevice = devices[chooseDevice(infos, options_.nameOrIndex)];
    adopted_.queueFamily = static_cast<uint32_t>(computeFamily(adopted_.physicalDevice));
    std::vector<const char*> extensions;
    void* more = nullptr;
    std::optional<RayTracingRequest> rayTracing;
    if (options_.rayTracing) {
        rayTracing.emplace(adopted_.physicalDevice);
        more = rayTracing->chain(nullptr);
        extensions.assign(rayTracing->extensions().begin(), rayTracing->extensions().end());
        rayTracing_ = rayTracing->found();
    }
    adopted_.queue = createDevice(adopted_.physicalDevice, adopted_.queueFamily, extensions, more, device_.put(),
                                  "opening the Vulkan device");
    adopted_.device = device_.get();
}

void Device::prepare() {
    VkPhysicalDeviceMaintenance4Properties maintenance4{};
    maintenance4.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES;
    VkPhysicalDeviceMaintenance3Properties maintenance3{};
    maintenance3.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
    maintenance3.pNext = &maintenance4;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    VkPhysicalDeviceSubgroupProperties subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    subgroup.pNext = &maintenance3;
    properties.pNext = &subgroup;
    vkGetPhysicalDeviceProperties2(physicalDevice(), &properties);
    properties_ = properties.properties;
    subgroupSize_ = subgroup.subgroupSize;
    largestAllocation_ = std::min(maintenance3.maxMemoryAllocationSize, maintenance4.maxBufferSize);
    if (options_.largestAllocation != 0)
        largestAllocation_ = std::min<uint64_t>(largestAllocation_, options_.largestAllocation);

    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice(), &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice(), &count, families.data());
    const uint32_t bits = families.at(adopted_.queueFamily).timestampValidBits;
    clockMask_ = bits >= 64 ? UINT64_MAX : (uint64_t(1) << bits) - 1;

    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT | VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool.queueFamilyIndex = adopted_.queueFamily;
    commandPool_ = Owned<VkDevice, VkCommandPool, vkDestroyCommandPool>(handle());
    check(vkCreateCommandPool(handle(), &pool, nullptr, commandPool_.put()), "creating the command pool");
    createPipelineCache();
    VmaAllocatorCreateInfo allocatorInfo{};
    allocatorInfo.flags = VMA_ALLOCATOR_CREATE_BUFFER_DEVICE_ADDRESS_BIT;
    allocatorInfo.instance = instance();
    allocatorInfo.physicalDevice = physicalDevice();
    allocatorInfo.device = handle();
    allocatorInfo.vulkanApiVersion = VK_API_VERSION_1_3;
    check(vmaCreateAllocator(&allocatorInfo, allocator_.put()), "creating the memory allocator");
}

std::string Device::pipelineKey() const {
    std::string key;
    for (uint8_t byte : properties_.pipelineCacheUUID) {
        key += "0123456789abcdef"[byte >> 4];
        key += "0123456789abcdef"[byte & 15];
    }
    return key;
}

void Device::createPipelineCache() {
    std::vector<char> data;
    if (options_.loadPipelines) data = options_.loadPipelines(pipelineKey());
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = data.size();
    info.pInitialData = data.data();
    pipelineCache_ = Owned<VkDevice, VkPipelineCache, vkDestroyPipelineCache>(handle());
    if (vkCreatePipelineCache(handle(), &info, nullptr, pipelineCache_.put()) == VK_SUCCESS) return;
    info.initialDataSize = 0;
    check(vkCreatePipelineCache(handle(), &info, nullptr, pipelineCache_.put()), "creating the pipeline cache");
}

// Best effort: without it, the next start compiles again.
void Device::storePipelineCache() {
    size_t size = 0;
    if (!options_.storePipelines || !pipelineCache_) return;
    if (vkGetPipelineCacheData(handle(), pipelineCache_.get(), &size, nullptr) != VK_SUCCESS) return;
    std::vector<char> data(size);
    if (vkGetPipelineCacheData(handle(), pipelineCache_.get(), &size, data.data()) != VK_SUCCESS) return;
    options_.storePipelines(pipelineKey(), data);
}

uint64_t Device::memoryInUse() const {
    VmaTotalStatistics statistics{};
    vmaCalculateStatistics(allocator(), &statistics);
    return statistics.total.statistics.allocationBytes;
}

StagingRing& Device::staging() {
    if (!staging_) staging_ = std::make_unique<StagingRing>(*this, options_.stagingBytes);
    return *staging_;
}

}  // namespace cleave
