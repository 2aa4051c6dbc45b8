#include "gpu/commands.h"

#include <algorithm>
#include <chrono>

#include "gpu/check.h"

namespace cleave {
namespace {

double nowMilliseconds() {
    using namespace std::chrono;
    return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

constexpr VkPipelineStageFlags2 kWork = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkAccessFlags2 kWrites = VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;

void barrier(VkCommandBuffer commands, VkPipelineStageFlags2 stages, VkAccessFlags2 access) {
    VkMemoryBarrier2 memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    memory.srcStageMask = kWork;
    memory.srcAccessMask = kWrites;
    memory.dstStageMask = stages;
    memory.dstAccessMask = access;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &memory;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

Commands::Commands(Device& device, uint32_t mostStamps)
    : device_(device), fence_(device.handle()), clock_(device.handle()), mostStamps_(mostStamps) {
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    check(vkCreateFence(device.handle(), &fence, nullptr, fence_.put()), "creating a fence");
    if (device.clockMask() != 0) {
        VkQueryPoolCreateInfo queries{};
        queries.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
        queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
        queries.queryCount = 2 + mostStamps;
        check(vkCreateQueryPool(device.handle(), &queries, nullptr, clock_.put()), "creating a query pool");
    }
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = device.commandPool();
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(device.handle(), &allocate, &commands_), "allocating a command buffer");
}

Commands::Commands(Commands&& other) noexcept
    : device_(other.device_),
      commands_(std::exchange(other.commands_, VK_NULL_HANDLE)),
      fence_(std::move(other.fence_)),
      clock_(std::move(other.clock_)),
      mostStamps_(other.mostStamps_),
      stamps_(std::move(other.stamps_)),
      pending_(std::exchange(other.pending_, false)) {}

Commands::~Commands() {
    if (!commands_) return;
    if (pending_) (void)vkQueueWaitIdle(device_.queue());
    vkFreeCommandBuffers(device_.handle(), device_.commandPool(), 1, &commands_);
}

void Commands::begin() {
    wait();
    stamps_.clear();
    passTimes_.clear();
    stampMilliseconds_.clear();
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands_, &begin), "recording commands");
    if (!clock_) return;
    vkCmdResetQueryPool(commands_, clock_.get(), 0, 2 + mostStamps_);
    vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, clock_.get(), 0);
}

void Commands::copy(VkBuffer from, VkDeviceSize fromOffset, VkBuffer to, VkDeviceSize toOffset, VkDeviceSize bytes) {
    barrier(commands_, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
            VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
    const VkBufferCopy region{fromOffset, toOffset, bytes};
    vkCmdCopyBuffer(commands_, from, to, 1, &region);
}

void Commands::fillZero(VkBuffer buffer) {
    barrier(commands_, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    vkCmdFillBuffer(commands_, buffer, 0, VK_WHOLE_SIZE, 0);
    barrier(commands_, kWork, VK_ACCESS_2_SHADER_READ_BIT | kWrites);
}

void Commands::stamp(const char* name) {
    if (!clock_ || stamps_.size() == mostStamps_) return;
    stamps_.push_back(name);
    vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, clock_.get(),
                         static_cast<uint32_t>(1 + stamps_.size()));
}

void Commands::submit() {
    barrier(commands_, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT | VK_ACCESS_2_HOST_WRITE_BIT);
    if (clock_) vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, clock_.get(), 1);
    check(vkEndCommandBuffer(commands_), "recording commands");
    VkCommandBufferSubmitInfo commands{};
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commands.commandBuffer = commands_;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    submittedAt_ = nowMilliseconds();
    check(vkQueueSubmit2(device_.queue(), 1, &submit, fence_.get()), "submitting work to the device");
    pending_ = true;
}

void Commands::wait() {
    if (!pending_) return;
    const VkFence fence = fence_.get();
    check(vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE, UINT64_MAX), "waiting for the device");
    pending_ = false;
    check(vkResetFences(device_.handle(), 1, &fence), "resetting a fence");
    readClock();
}

void Commands::readClock() {
    milliseconds_ = nowMilliseconds() - submittedAt_;
    if (!clock_) return;
    std::vector<uint64_t> ticks(2 + stamps_.size());
    check(vkGetQueryPoolResults(device_.handle(), clock_.get(), 0, static_cast<uint32_t>(ticks.size()),
                                ticks.size() * sizeof(uint64_t), ticks.data(), sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "reading the device's clock");
    // The clock may run over: differences of the valid bits are right all the same.
    const auto between = [&](uint64_t from, uint64_t to) {
        return static_cast<double>((to - from) & device_.clockMask()) * device_.properties().limits.timestampPeriod *
               1e-6;
    };
    milliseconds_ = between(ticks[0], ticks[1]);
    for (size_t i = 0; i < stamps_.size(); i++) {
        auto known = std::find_if(passTimes_.begin(), passTimes_.end(),
                                  [&](const PassTime& time) { return time.name == stamps_[i]; });
        if (known == passTimes_.end()) known = passTimes_.insert(known, PassTime{stamps_[i]});
        stampMilliseconds_.push_back(between(i == 0 ? ticks[0] : ticks[1 + i], ticks[2 + i]));
        known->ms += stampMilliseconds_.back();
    }
}

}  // namespace cleave
