#include "record/recorder.h"

#include <algorithm>

namespace cleave {

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
    f_.CmdPipelineBarrier2(commands_, &dependency);
}

void Recorder::write(VkBuffer buffer, VkDeviceSize offset, const void* data, VkDeviceSize bytes) {
    constexpr VkDeviceSize kMost = 65536;  // of one vkCmdUpdateBuffer
    barrier();
    for (VkDeviceSize at = 0; at < bytes; at += kMost)
        f_.CmdUpdateBuffer(commands_, buffer, offset + at, std::min(kMost, bytes - at),
                           static_cast<const char*>(data) + at);
}

void Recorder::fillZero(VkBuffer buffer, VkDeviceSize offset, VkDeviceSize bytes) {
    barrier();
    f_.CmdFillBuffer(commands_, buffer, offset, bytes, 0);
}

}  // namespace cleave
