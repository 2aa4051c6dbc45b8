#include "gpu/buffer.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "gpu/allocator.h"
#include "gpu/recorder.h"

namespace cleave {

namespace {

constexpr size_t kStagingBytes = size_t(16) << 20;

// Memory that both sides see, for one transfer.
class Staging {
  public:
    Staging(Context& context, size_t bytes) : context_(context) {
        VkBufferCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = bytes;
        info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
        VmaAllocationCreateInfo memory{};
        memory.usage = VMA_MEMORY_USAGE_AUTO_PREFER_HOST;
        memory.flags = VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT | VMA_ALLOCATION_CREATE_MAPPED_BIT;
        VmaAllocationInfo got{};
        check(vmaCreateBuffer(context.allocator, &info, &memory, &handle, &allocation, &got),
              "allocating a transfer buffer");
        mapped = got.pMappedData;
    }
    ~Staging() { vmaDestroyBuffer(context_.allocator, handle, allocation); }
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;

    VkBuffer handle = VK_NULL_HANDLE;
    VmaAllocation allocation = nullptr;
    void* mapped = nullptr;

  private:
    Context& context_;
};

}  // namespace

Buffer::Buffer(Context& context, size_t bytes) : context_(&context), size_(bytes) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = std::max<size_t>(bytes, 4);
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT |
                 VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VmaAllocationCreateInfo memory{};
    memory.usage = VMA_MEMORY_USAGE_AUTO_PREFER_DEVICE;
    memory.flags = VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT |
                   VMA_ALLOCATION_CREATE_HOST_ACCESS_ALLOW_TRANSFER_INSTEAD_BIT | VMA_ALLOCATION_CREATE_MAPPED_BIT;
    VmaAllocationInfo got{};
    const VkResult result = vmaCreateBuffer(context.allocator, &info, &memory, &handle_, &allocation_, &got);
    if (result != VK_SUCCESS)
        check(result, ("allocating " + std::to_string((bytes >> 20) + 1) + " MiB on the device").c_str());
    mapped_ = got.pMappedData;
    VkBufferDeviceAddressInfo address{};
    address.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO;
    address.buffer = handle_;
    address_ = vkGetBufferDeviceAddress(context.device, &address);
}

Buffer::~Buffer() {
    if (handle_) vmaDestroyBuffer(context_->allocator, handle_, allocation_);
}

Buffer::Buffer(Buffer&& other) noexcept { *this = std::move(other); }

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(context_, other.context_);
    std::swap(handle_, other.handle_);
    std::swap(allocation_, other.allocation_);
    std::swap(mapped_, other.mapped_);
    std::swap(size_, other.size_);
    std::swap(address_, other.address_);
    return *this;
}

void Buffer::write(size_t offset, const void* data, size_t bytes) {
    if (bytes == 0) return;
    if (offset > size_ || bytes > size_ - offset) throw Error("internal: writing past the end of a device buffer");
    if (mapped_) {
        std::memcpy(static_cast<char*>(mapped_) + offset, data, bytes);
        check(vmaFlushAllocation(context_->allocator, allocation_, offset, bytes), "flushing device memory");
        return;
    }
    Staging staging(*context_, std::min(bytes, kStagingBytes));
    for (size_t at = 0; at < bytes; at += kStagingBytes) {
        const size_t part = std::min(kStagingBytes, bytes - at);
        std::memcpy(staging.mapped, static_cast<const char*>(data) + at, part);
        check(vmaFlushAllocation(context_->allocator, staging.allocation, 0, part), "flushing device memory");
        Recorder recorder(*context_);
        recorder.copy(staging.handle, 0, handle_, offset + at, part);
        recorder.submit();
    }
}

void Buffer::read(size_t offset, void* data, size_t bytes) const {
    if (bytes == 0) return;
    if (offset > size_ || bytes > size_ - offset) throw Error("internal: reading past the end of a device buffer");
    if (mapped_) {
        check(vmaInvalidateAllocation(context_->allocator, allocation_, offset, bytes), "reading device memory");
        std::memcpy(data, static_cast<const char*>(mapped_) + offset, bytes);
        return;
    }
    Staging staging(*context_, std::min(bytes, kStagingBytes));
    for (size_t at = 0; at < bytes; at += kStagingBytes) {
        const size_t part = std::min(kStagingBytes, bytes - at);
        Recorder recorder(*context_);
        recorder.copy(handle_, offset + at, staging.handle, 0, part);
        recorder.submit();
        check(vmaInvalidateAllocation(context_->allocator, staging.allocation, 0, part), "reading device memory");
        std::memcpy(static_cast<char*>(data) + at, staging.mapped, part);
    }
}

}  // namespace cleave
