// Moves bytes between the host and device memory that the host does not see.
#pragma once

#include <array>

#include "gpu/commands.h"

VK_DEFINE_HANDLE(VmaAllocation)

namespace cleave {

// A ring of two slots of host memory: while the device copies one, the host treats the other.
class StagingRing {
  public:
    // `bytes` of host memory in all, at least 8.
    StagingRing(Device& device, size_t bytes);
    ~StagingRing();
    StagingRing(const StagingRing&) = delete;
    StagingRing& operator=(const StagingRing&) = delete;

    // They return when the bytes are there. The caller has waited for the work that uses the buffer.
    void upload(VkBuffer to, VkDeviceSize offset, const void* data, VkDeviceSize bytes);
    void download(VkBuffer from, VkDeviceSize offset, void* data, VkDeviceSize bytes);

  private:
    static constexpr size_t kSlots = 2;

    Device& device_;
    VkDeviceSize slotBytes_ = 0;
    VkBuffer handle_ = VK_NULL_HANDLE;
    VmaAllocation allocation_ = nullptr;
    char* mapped_ = nullptr;
    std::array<Commands, kSlots> commands_;

    void copy(Commands& commands, VkBuffer from, VkDeviceSize fromOffset, VkBuffer to, VkDeviceSize toOffset,
              VkDeviceSize bytes);
};

}  // namespace cleave
