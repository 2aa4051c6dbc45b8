#include "gpu/device.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "gpu/allocator.h"
#include "gpu/instance.h"

namespace cleave {

void check(VkResult result, const char* what) {
    if (result == VK_SUCCESS) return;
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
        throw Error(std::string(what) + ": the device is out of memory; use --memory or a smaller scene");
    if (result == VK_ERROR_DEVICE_LOST) throw Error(std::string(what) + ": the device was lost; try another --device");
    throw Error(std::string(what) + ": Vulkan error " + std::to_string(result));
}

void ContextDeleter::operator()(Context* context) const { delete context; }

ContextPointer openDevice(const std::string& nameOrIndex) { return ContextPointer(new Context(nameOrIndex)); }

std::string deviceName(const Context& context) { return context.properties.deviceName; }
uint64_t validationMessages(const Context& context) { return context.validation->messages; }
double setupMilliseconds(const Context& context) { return context.setupMs; }

namespace {
// Where pipelines are kept from run to run; empty if there is no place for them.
std::filesystem::path cacheFile(const VkPhysicalDeviceProperties& properties) {
    std::filesystem::path folder;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg)
        folder = xdg;
    else if (const char* home = std::getenv("HOME"); home && *home)
        folder = std::filesystem::path(home) / ".cache";
    else
        return {};
    std::string name = "pipelines-";
    for (uint8_t byte : properties.pipelineCacheUUID) {
        name += "0123456789abcdef"[byte >> 4];
        name += "0123456789abcdef"[byte & 15];
    }
    return folder / "cleave" / name;
}
}  // namespace

Context::Context(const std::string& nameOrIndex) {
    try {
        instance = createInstance(validation.get(), &messenger_);
        const std::vector<VkPhysicalDevice> devices = physicalDevices(instance);
        std::vector<DeviceInfo> infos;
        for (VkPhysicalDevice d : devices) infos.push_back(describe(d, static_cast<uint32_t>(infos.size())));
        openDevice(devices[chooseDevice(infos, nameOrIndex)]);
    } catch (...) {
        destroy();
        throw;
    }
}

Context::~Context() {
    savePipelineCache();
    destroy();
}

void Context::openDevice(VkPhysicalDevice chosen) {
    physical = chosen;
    vkGetPhysicalDeviceProperties(physical, &properties);
    queueFamily = static_cast<uint32_t>(computeFamily(physical));
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queueInfo{};
    queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queueInfo.queueFamilyIndex = queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkPhysicalDeviceVulkan13Features f13{};
    f13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    f13.synchronization2 = VK_TRUE;
    f13.maintenance4 = VK_TRUE;  // workgroup sizes from specialisation constants
    VkPhysicalDeviceVulkan12Features f12{};
    f12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    f12.pNext = &f13;
    f12.bufferDeviceAddress = VK_TRUE;
    f12.scalarBlockLayout = VK_TRUE;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &f12;
    features.features.shaderFloat64 = VK_TRUE;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    check(vkCreateDevice(physical, &info, nullptr, &device), "opening the Vulkan device");
    vkGetDeviceQueue(device, queueFamily, 0, &queue);
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = queueFamily;
    check(vkCreateCommandPool(device, &pool, nullptr, &commandPool), "creating the command pool");
    VmaAllocatorCreateInfo allocatorInfo{};
    allocatorInfo.flags = VMA_ALLOCATOR_CREATE_BUFFER_DEVICE_ADDRESS_BIT;
    allocatorInfo.instance = instance;
    allocatorInfo.physicalDevice = physical;
    allocatorInfo.device = device;
    allocatorInfo.vulkanApiVersion = VK_API_VERSION_1_3;
    check(vmaCreateAllocator(&allocatorInfo, &allocator), "creating the memory allocator");
    loadPipelineCache();
}

// A damaged file does no harm: the driver checks the header, and what it refuses is built anew.
void Context::loadPipelineCache() {
    std::vector<char> data;
    if (const auto file = cacheFile(properties); !file.empty()) {
        std::ifstream in(file, std::ios::binary);
        data.assign(std::istreambuf_iterator<char>(in), {});
    }
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = data.size();
    info.pInitialData = data.data();
    if (vkCreatePipelineCache(device, &info, nullptr, &pipelineCache) == VK_SUCCESS) return;
    info.initialDataSize = 0;
    check(vkCreatePipelineCache(device, &info, nullptr, &pipelineCache), "creating the pipeline cache");
}

// Best effort: without a place to write, the next start compiles again.
void Context::savePipelineCache() {
    size_t size = 0;
    const auto file = cacheFile(properties);
    if (file.empty() || vkGetPipelineCacheData(device, pipelineCache, &size, nullptr) != VK_SUCCESS) return;
    std::vector<char> data(size);
    if (vkGetPipelineCacheData(device, pipelineCache, &size, data.data()) != VK_SUCCESS) return;
    std::error_code ignored;
    if (std::filesystem::file_size(file, ignored) == size && !ignored) return;
    std::filesystem::create_directories(file.parent_path(), ignored);
    const std::filesystem::path beside = file.string() + "." + std::to_string(getpid());
    std::ofstream(beside, std::ios::binary).write(data.data(), static_cast<std::streamsize>(size));
    std::filesystem::rename(beside, file, ignored);
}

void Context::destroy() {
    if (device) {
        vkDeviceWaitIdle(device);
        if (pipelineCache) vkDestroyPipelineCache(device, pipelineCache, nullptr);
        if (allocator) vmaDestroyAllocator(allocator);
        if (commandPool) vkDestroyCommandPool(device, commandPool, nullptr);
        vkDestroyDevice(device, nullptr);
    }
    destroyInstance(instance, messenger_);
}

}  // namespace cleave
