#include "gpu/staging.h"

#include <algorithm>
#include <cstring>

#include "gpu/allocator.h"
#include "gpu/check.h"

namespace cleave {

StagingRing::StagingRing(Device& device, size_t bytes)
    : device_(device), slotBytes_(bytes / kSlots / 4 * 4), commands_{Commands(device), Commands(device)} {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = slotBytes_ * kSlots;
    info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VmaAllocationCreateInfo memory{};
    memory.usage = VMA_MEMORY_USAGE_AUTO_PREFER_HOST;
    memory.flags = VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT | VMA_ALLOCATION_CREATE_MAPPED_BIT;
    VmaAllocationInfo got{};
    check(vmaCreateBuffer(device.allocator(), &info, &memory, &handle_, &allocation_, &got),
          "allocating a transfer buffer");
    mapped_ = static_cast<char*>(got.pMappedData);
}

StagingRing::~StagingRing() { vmaDestroyBuffer(device_.allocator(), handle_, allocation_); }

void StagingRing::copy(Commands& commands, VkBuffer from, VkDeviceSize fromOffset, VkBuffer to, VkDeviceSize toOffset,
                       VkDeviceSize bytes) {
    commands.begin();
    commands.copy(from, fromOffset, to, toOffset, bytes);
    commands.submit();
}

void StagingRing::upload(VkBuffer to, VkDeviceSize offset, const void* data, VkDeviceSize bytes) {
    size_t slot = 0;
    for (VkDeviceSize at = 0; at < bytes; at += slotBytes_, slot = (slot + 1) % kSlots) {
        const VkDeviceSize part = std::min(slotBytes_, bytes - at);
        const VkDeviceSize place = slot * slotBytes_;
        commands_[slot].wait();
        std::memcpy(mapped_ + place, static_cast<const char*>(data) + at, part);
        check(vmaFlushAllocation(device_.allocator(), allocation_, place, part), "flushing a transfer buffer");
        copy(commands_[slot], handle_, place, to, offset + at, part);
    }
    for (Commands& c : commands_) c.wait();
}

void StagingRing::download(VkBuffer from, VkDeviceSize offset, void* data, VkDeviceSize bytes) {
    // Part k arrives while part k - 1 is taken out.
    const auto parts = (bytes + slotBytes_ - 1) / slotBytes_;
    const auto partBytes = [&](VkDeviceSize k) { return std::min(slotBytes_, bytes - k * slotBytes_); };
    for (VkDeviceSize k = 0; k <= parts; k++) {
        if (k < parts)
            copy(commands_[k % kSlots], from, offset + k * slotBytes_, handle_, k % kSlots * slotBytes_, partBytes(k));
        if (k == 0) continue;
        const VkDeviceSize done = k - 1;
        const VkDeviceSize place = done % kSlots * slotBytes_;
        commands_[done % kSlots].wait();
        check(vmaInvalidateAllocation(device_.allocator(), allocation_, place, partBytes(done)),
              "reading a transfer buffer");
        std::memcpy(static_cast<char*>(data) + done * slotBytes_, mapped_ + place, partBytes(done));
    }
}

}  // namespace cleave
