// The Vulkan functions that recording needs, loaded for one device through the caller's vkGetInstanceProcAddr: the
// library links no loader.
#pragma once

#include <vulkan/vulkan_core.h>

namespace cleave {

#define CLEAVE_DEVICE_FUNCTIONS(ROW) \
    ROW(CreateShaderModule)          \
    ROW(DestroyShaderModule)         \
    ROW(CreatePipelineLayout)        \
    ROW(DestroyPipelineLayout)       \
    ROW(CreateComputePipelines)      \
    ROW(DestroyPipeline)             \
    ROW(CmdBindPipeline)             \
    ROW(CmdPushConstants)            \
    ROW(CmdDispatch)                 \
    ROW(CmdDispatchIndirect)         \
    ROW(CmdPipelineBarrier2)         \
    ROW(CmdUpdateBuffer)             \
    ROW(CmdFillBuffer)

struct Functions {
#define CLEAVE_MEMBER(name) PFN_vk##name name = nullptr;
    CLEAVE_DEVICE_FUNCTIONS(CLEAVE_MEMBER)
#undef CLEAVE_MEMBER

    // The name of a function that is missing, or null.
    const char* load(PFN_vkGetInstanceProcAddr instanceFunction, VkInstance instance, VkDevice device) noexcept;
};

}  // namespace cleave
