// The Vulkan that a program of its own has open: a device, memory, a kernel, validation with synchronisation. Functions
// come from the loader or, with CONSUMER_USES_VOLK, from volk.
#pragma once

#ifdef CONSUMER_USES_VOLK
#define VOLK_IMPLEMENTATION
#include <volk.h>
#else
#include <vulkan/vulkan.h>
#endif

#include <cleave/cleave.hpp>
#include <cstdio>
#include <cstdlib>

#define MUST(call) require((call) == VK_SUCCESS, #call)

inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "failed: %s\n", what);
    std::exit(1);
}

inline int validationMessages = 0;

inline VkBool32 VKAPI_PTR onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                    const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    std::fprintf(stderr, "validation: %s\n", data->pMessage);
    validationMessages++;
    return VK_FALSE;
}

inline VkInstance openInstance() {
#ifdef CONSUMER_USES_VOLK
    MUST(volkInitialize());
#endif
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = cleave::requirements().apiVersion;
    const VkValidationFeatureEnableEXT sync = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT validation{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    validation.enabledValidationFeatureCount = 1;
    validation.pEnabledValidationFeatures = &sync;
    const char* layer = "VK_LAYER_KHRONOS_validation";
    const char* extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, &validation, 0, &application};
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &layer;
    info.enabledExtensionCount = 2;
    info.ppEnabledExtensionNames = extensions;
    VkInstance instance;
    MUST(vkCreateInstance(&info, nullptr, &instance));
#ifdef CONSUMER_USES_VOLK
    volkLoadInstance(instance);
#endif
    VkDebugUtilsMessengerCreateInfoEXT listen{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    listen.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    listen.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    listen.pfnUserCallback = onMessage;
    VkDebugUtilsMessengerEXT messenger;
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
    MUST(create(instance, &listen, nullptr, &messenger));
    return instance;
}

struct Memory {
    cleave::Range range;
    char* mapped;
};

// Makes what was written by shaders and transfers visible to shaders and to the host.
inline void barrier(VkCommandBuffer commands) {
    VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    memory.srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    memory.srcAccessMask = VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;
    memory.dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_HOST_BIT;
    memory.dstAccessMask = VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &memory;
    vkCmdPipelineBarrier2(commands, &info);
}

constexpr VkBufferUsageFlags kShaderData =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;

struct OwnVulkan {
    VkInstance instance = openInstance();
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    VkQueue queue;
    VkCommandPool pool;

    // The first device, and its first family, which every driver here gives compute. Chains in what cleave needs.
    OwnVulkan() {
        uint32_t one = 1;
        require(vkEnumeratePhysicalDevices(instance, &one, &physicalDevice) >= 0 && one == 1, "finding a device");
        cleave::Requirements needed = cleave::requirements();
        needed.vulkan12.pNext = &needed.vulkan13;
        const VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &needed.vulkan12,
                                                 needed.features};
        const float priority = 1.0f;
        VkDeviceQueueCreateInfo queueInfo{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, 0, 1, &priority};
        const VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features, 0, 1, &queueInfo};
        MUST(vkCreateDevice(physicalDevice, &info, nullptr, &device));
#ifdef CONSUMER_USES_VOLK
        volkLoadDevice(device);
#endif
        vkGetDeviceQueue(device, 0, 0, &queue);
        const VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
        MUST(vkCreateCommandPool(device, &poolInfo, nullptr, &pool));
    }

    // A buffer in memory that the host sees, which every device has.
    Memory allocate(VkDeviceSize bytes, VkBufferUsageFlags usage = kShaderData) const {
        Memory made{{VK_NULL_HANDLE, 0, bytes, 0}, nullptr};
        const VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, nullptr, 0, bytes, usage};
        MUST(vkCreateBuffer(device, &info, nullptr, &made.range.buffer));
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(device, made.range.buffer, &needs);
        VkPhysicalDeviceMemoryProperties memory;
        vkGetPhysicalDeviceMemoryProperties(physicalDevice, &memory);
        const VkMemoryPropertyFlags seen = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        uint32_t type = 0;
        while (!(needs.memoryTypeBits >> type & 1) || (memory.memoryTypes[type].propertyFlags & seen) != seen) type++;
        const VkMemoryAllocateFlagsInfo flags{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO, nullptr,
                                              VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT};
        const VkMemoryAllocateInfo allocation{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &flags, needs.size, type};
        VkDeviceMemory block;
        MUST(vkAllocateMemory(device, &allocation, nullptr, &block));
        MUST(vkBindBufferMemory(device, made.range.buffer, block, 0));
        void* mapped;
        MUST(vkMapMemory(device, block, 0, VK_WHOLE_SIZE, 0, &mapped));
        made.mapped = static_cast<char*>(mapped);
        VkBufferDeviceAddressInfo address{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO};
        address.buffer = made.range.buffer;
        made.range.address = vkGetBufferDeviceAddress(device, &address);
        return made;
    }

    VkCommandBuffer begin() const {
        VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool};
        info.commandBufferCount = 1;
        VkCommandBuffer commands;
        MUST(vkAllocateCommandBuffers(device, &info, &commands));
        const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
        MUST(vkBeginCommandBuffer(commands, &begin));
        return commands;
    }

    // Submits, and waits.
    void run(VkCommandBuffer commands) const {
        MUST(vkEndCommandBuffer(commands));
        VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
        submit.commandBufferCount = 1;
        submit.pCommandBuffers = &commands;
        MUST(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE));
        MUST(vkDeviceWaitIdle(device));
    }

    // Records a kernel without descriptors.
    template <class Push, size_t words>
    void dispatch(VkCommandBuffer commands, const uint32_t (&spirv)[words], const Push& push, uint32_t groups) const {
        const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Push)};
        VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
        layoutInfo.pushConstantRangeCount = 1;
        layoutInfo.pPushConstantRanges = &range;
        VkPipelineLayout layout;
        MUST(vkCreatePipelineLayout(device, &layoutInfo, nullptr, &layout));
        const VkShaderModuleCreateInfo code{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, nullptr, 0, sizeof(spirv),
                                            spirv};
        VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
        info.layout = layout;
        info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        info.stage.pName = "main";
        MUST(vkCreateShaderModule(device, &code, nullptr, &info.stage.module));
        VkPipeline pipeline;
        MUST(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline));
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
        vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Push), &push);
        vkCmdDispatch(commands, groups, 1, 1);
    }
};
