// Device memory.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gpu/device.h"

VK_DEFINE_HANDLE(VmaAllocation)

namespace cleave {

// A buffer that kernels reach by its address. Sizes are in bytes; an empty one still has an address.
class Buffer {
  public:
    Buffer() = default;
    // Throws Error if the device has not so much memory, or gives not so much in one piece. `uses`: what the buffer is
    // for beside what kernels and transfers do.
    Buffer(Device& device, uint64_t bytes, VkBufferUsageFlags uses = 0);
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    uint64_t size() const { return size_; }
    VkBuffer handle() const { return handle_.get(); }
    uint64_t address() const { return address_; }

    // Waits for nothing: the caller has waited for the work that uses the buffer. Ranges must lie inside.
    void write(uint64_t offset, const void* data, uint64_t bytes);
    void read(uint64_t offset, void* data, uint64_t bytes) const;

    template <class T>
    void upload(std::span<const T> items) {
        write(0, items.data(), items.size_bytes());
    }
    template <class T>
    std::vector<T> download(size_t count) const {
        std::vector<T> items(count);
        read(0, items.data(), count * sizeof(T));
        return items;
    }

  private:
    static void freeMemory(VmaAllocator allocator, VmaAllocation allocation, const VkAllocationCallbacks*);

    Device* device_ = nullptr;
    Owned<VmaAllocator, VmaAllocation, freeMemory> memory_;  // outlives the handle
    Owned<VkDevice, VkBuffer, vkDestroyBuffer> handle_;
    void* mapped_ = nullptr;     // null where the host does not see the device's memory
    bool cachedByHost_ = false;  // see MemoryType
    uint64_t size_ = 0;
    uint64_t address_ = 0;

    void requireInside(uint64_t offset, uint64_t bytes) const;
};

// A buffer that holds the items.
template <class T>
Buffer uploaded(Device& device, std::span<const T> items) {
    Buffer buffer(device, items.size_bytes());
    buffer.upload(items);
    return buffer;
}

}  // namespace cleave
