#include "recorder.h"

#include <chrono>

#include "error.h"
#include "shared/dispatch.h"

namespace cleave {

Recorder::Recorder(Context& context) : context_(context) {
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = context.commandPool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(context.device, &allocate, &commands_), "allocating a command buffer");
    VkQueryPoolCreateInfo queries{};
    queries.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queries.queryCount = 2;
    check(vkCreateQueryPool(context.device, &queries, nullptr, &times_), "creating a query pool");
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    check(vkCreateFence(context.device, &fence, nullptr, &fence_), "creating a fence");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands_, &begin), "recording commands");
    vkCmdResetQueryPool(commands_, times_, 0, 2);
    vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, times_, 0);
}

Recorder::~Recorder() {
    vkDestroyFence(context_.device, fence_, nullptr);
    vkDestroyQueryPool(context_.device, times_, nullptr);
    vkFreeCommandBuffers(context_.device, context_.commandPool, 1, &commands_);
}

void Recorder::barrier() {
    VkMemoryBarrier2 memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    memory.srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    memory.srcAccessMask = VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_TRANSFER_READ_BIT |
                           VK_ACCESS_2_TRANSFER_WRITE_BIT;
    memory.dstStageMask = memory.srcStageMask | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT;
    memory.dstAccessMask = memory.srcAccessMask | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &memory;
    vkCmdPipelineBarrier2(commands_, &dependency);
}

void Recorder::bind(const Kernel& kernel, const void* push, size_t pushBytes) {
    if (pushBytes != kernel.pushBytes())
        throw Error("internal: kernel " + kernel.name() + " takes " + std::to_string(kernel.pushBytes()) +
                    " bytes of push constants, not " + std::to_string(pushBytes));
    barrier();
    vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, kernel.pipeline());
    vkCmdPushConstants(commands_, kernel.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, static_cast<uint32_t>(pushBytes),
                       push);
}

void Recorder::dispatchBytes(const Kernel& kernel, const void* push, size_t pushBytes, uint32_t groups) {
    bind(kernel, push, pushBytes);
    const DispatchSize size = dispatchSize(groups);
    vkCmdDispatch(commands_, size.x, size.y, size.z);
}

void Recorder::dispatchIndirectBytes(const Kernel& kernel, const void* push, size_t pushBytes, const Buffer& sizes,
                                     size_t offset) {
    bind(kernel, push, pushBytes);
    vkCmdDispatchIndirect(commands_, sizes.handle(), offset);
}

void Recorder::copy(VkBuffer from, size_t fromOffset, VkBuffer to, size_t toOffset, size_t bytes) {
    if (bytes == 0) return;
    barrier();
    const VkBufferCopy region{fromOffset, toOffset, bytes};
    vkCmdCopyBuffer(commands_, from, to, 1, &region);
}

void Recorder::fillZero(const Buffer& buffer) {
    barrier();
    vkCmdFillBuffer(commands_, buffer.handle(), 0, VK_WHOLE_SIZE, 0);
}

double Recorder::submit() {
    // The host may read and write every buffer afterwards.
    VkMemoryBarrier2 memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    memory.srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    memory.srcAccessMask = VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;
    memory.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    memory.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT | VK_ACCESS_2_HOST_WRITE_BIT;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &memory;
    vkCmdPipelineBarrier2(commands_, &dependency);
    vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, times_, 1);
    check(vkEndCommandBuffer(commands_), "recording commands");
    VkCommandBufferSubmitInfo commands{};
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commands.commandBuffer = commands_;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    check(vkQueueSubmit2(context_.queue, 1, &submit, fence_), "submitting work to the device");
    check(vkWaitForFences(context_.device, 1, &fence_, VK_TRUE, UINT64_MAX), "waiting for the device");
    uint64_t ticks[2] = {0, 0};
    check(vkGetQueryPoolResults(context_.device, times_, 0, 2, sizeof(ticks), ticks, sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "reading the device's clock");
    return static_cast<double>(ticks[1] - ticks[0]) * context_.properties.limits.timestampPeriod * 1e-6;
}

}  // namespace cleave
