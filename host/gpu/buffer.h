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
    Buffer(Context& context, size_t bytes);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    size_t size() const { return size_; }
    VkBuffer handle() const { return handle_; }
    uint64_t address() const { return address_; }

    // Waits for nothing: the caller has waited for the work that uses the buffer. Ranges must lie inside.
    void write(size_t offset, const void* data, size_t bytes);
    void read(size_t offset, void* data, size_t bytes) const;

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
    Context* context_ = nullptr;
    VkBuffer handle_ = VK_NULL_HANDLE;
    VmaAllocation allocation_ = nullptr;
    void* mapped_ = nullptr;  // null where the device's memory cannot be seen from the host
    size_t size_ = 0;
    uint64_t address_ = 0;
};

}  // namespace cleave
