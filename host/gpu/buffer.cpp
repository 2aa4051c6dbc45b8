#include "gpu/buffer.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "gpu/allocator.h"
#include "gpu/check.h"
#include "gpu/memory_type.h"
#include "gpu/staging.h"

namespace cleave {

namespace {

// What is read over the bus in less time than staging takes: a header, the counters of a dispatch.
constexpr uint64_t kFewBytes = 256;

std::string mebibytes(uint64_t bytes) { return std::to_string((bytes >> 20) + 1) + " MiB"; }

}  // namespace

Buffer::Buffer(Device& device, uint64_t bytes, VkBufferUsageFlags uses)
    : device_(&device), memory_(device.allocator()), handle_(device.handle()), size_(bytes) {
    if (bytes > device.largestAllocation())
        throw Error("the device gives at most " + mebibytes(device.largestAllocation()) + " in one piece, and " +
                    mebibytes(bytes) + " are needed; use a smaller scene or picture");
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = std::max<uint64_t>(bytes, 4);
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT |
                 VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT | uses;
    check(vkCreateBuffer(device.handle(), &info, nullptr, handle_.put()), "creating a buffer");
    VkMemoryRequirements needed;
    vkGetBufferMemoryRequirements(device.handle(), handle(), &needed);
    const VkPhysicalDeviceMemoryProperties* offered = nullptr;
    vmaGetMemoryProperties(device.allocator(), &offered);
    const MemoryType type = memoryTypeFor(*offered, needed.memoryTypeBits, device.maps());
    cachedByHost_ = type.cachedByHost && device.hostCaches();
    VmaAllocationCreateInfo memory{};
    memory.memoryTypeBits = uint32_t(1) << type.index;
    if (type.mapped) memory.flags = VMA_ALLOCATION_CREATE_MAPPED_BIT;
    VmaAllocationInfo got{};
    check(vmaAllocateMemoryForBuffer(device.allocator(), handle(), &memory, memory_.put(), &got),
          "allocating " + mebibytes(bytes) + " on the device");
    check(vmaBindBufferMemory(device.allocator(), memory_.get(), handle()), "giving a buffer its memory");
    mapped_ = got.pMappedData;
    VkBufferDeviceAddressInfo address{};
    address.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO;
    address.buffer = handle();
    address_ = vkGetBufferDeviceAddress(device.handle(), &address);
}

void Buffer::freeMemory(VmaAllocator allocator, VmaAllocation allocation, const VkAllocationCallbacks*) {
    vmaFreeMemory(allocator, allocation);
}

Buffer::Buffer(Buffer&& other) noexcept { *this = std::move(other); }

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(memory_, other.memory_);
    std::swap(handle_, other.handle_);
    std::swap(mapped_, other.mapped_);
    std::swap(cachedByHost_, other.cachedByHost_);
    std::swap(size_, other.size_);
    std::swap(address_, other.address_);
    return *this;
}

void Buffer::requireInside(uint64_t offset, uint64_t bytes) const {
    if (offset > size_ || bytes > size_ - offset) throw Error("internal: a transfer past the end of a device buffer");
}

void Buffer::write(uint64_t offset, const void* data, uint64_t bytes) {
    if (bytes == 0) return;
    requireInside(offset, bytes);
    device_->transfers.upBytes += bytes;
    if (!mapped_) return device_->staging().upload(handle(), offset, data, bytes);
    std::memcpy(static_cast<char*>(mapped_) + offset, data, bytes);
    check(vmaFlushAllocation(device_->allocator(), memory_.get(), offset, bytes), "flushing device memory");
}

void Buffer::read(uint64_t offset, void* data, uint64_t bytes) const {
    if (bytes == 0) return;
    requireInside(offset, bytes);
    device_->transfers.downBytes += bytes;
    if (!mapped_ || (!cachedByHost_ && bytes > kFewBytes))
        return device_->staging().download(handle(), offset, data, bytes);
    check(vmaInvalidateAllocation(device_->allocator(), memory_.get(), offset, bytes), "reading device memory");
    std::memcpy(data, static_cast<const char*>(mapped_) + offset, bytes);
}

}  // namespace cleave
