#include "gpu/recorder.h"

#include <algorithm>

#include "base/error.h"
#include "shared/dispatch.h"

namespace cleave {

Recorder::Recorder(Context& context, bool timesKernels)
    : context_(context), timeCount_(2 + (timesKernels ? kMostTimed : 0)) {
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = context.commandPool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(context.device, &allocate, &commands_), "allocating a command buffer");
    VkQueryPoolCreateInfo queries{};
    queries.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queries.queryCount = timeCount_;
    check(vkCreateQueryPool(context.device, &queries, nullptr, &times_), "creating a query pool");
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    check(vkCreateFence(context.device, &fence, nullptr, &fence_), "creating a fence");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands_, &begin), "recording commands");
    vkCmdResetQueryPool(commands_, times_, 0, timeCount_);
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
    noteEnd(kernel);
}

void Recorder::dispatchIndirectBytes(const Kernel& kernel, const void* push, size_t pushBytes, const Buffer& sizes,
                                     size_t offset) {
    bind(kernel, push, pushBytes);
    vkCmdDispatchIndirect(commands_, sizes.handle(), offset);
    noteEnd(kernel);
}

void Recorder::noteEnd(const Kernel& kernel) {
    if (timeCount_ == 2) return;
    const auto entry = static_cast<uint32_t>(2 + timed_.size());
    if (entry == timeCount_) throw Error("internal: more dispatches than a recorder can time");
    vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, times_, entry);
    timed_.push_back(&kernel);
}

// From the end of the dispatch before: barriers count to what waits for them.
void Recorder::sumTimes(const std::vector<uint64_t>& ticks) {
    for (size_t i = 0; i < timed_.size(); i++) {
        const std::string& name = timed_[i]->name();
        auto known = std::find_if(kernelTimes_.begin(), kernelTimes_.end(),
                                  [&](const KernelTime& time) { return time.name == name; });
        if (known == kernelTimes_.end()) known = kernelTimes_.insert(known, KernelTime{name});
        known->ms += milliseconds(i == 0 ? ticks[0] : ticks[1 + i], ticks[2 + i]);
    }
}

double Recorder::milliseconds(uint64_t from, uint64_t to) const {
    return static_cast<double>(to - from) * context_.properties.limits.timestampPeriod * 1e-6;
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
    std::vector<uint64_t> ticks(2 + timed_.size());
    check(vkGetQueryPoolResults(context_.device, times_, 0, static_cast<uint32_t>(ticks.size()),
                                ticks.size() * sizeof(uint64_t), ticks.data(), sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "reading the device's clock");
    sumTimes(ticks);
    return milliseconds(ticks[0], ticks[1]);
}

}  // namespace cleave
