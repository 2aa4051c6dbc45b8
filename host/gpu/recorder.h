// Records work for the device and runs it.
#pragma once

#include <type_traits>

#include "gpu/buffer.h"
#include "gpu/kernel.h"

namespace cleave {

// One command buffer. Every command sees what the ones before it wrote. Submitted once, waited for.
class Recorder {
  public:
    // `timesKernels`: the clock is read after every dispatch, of which there may be kMostTimed.
    static constexpr uint32_t kMostTimed = 4096;
    explicit Recorder(Context& context, bool timesKernels = false);
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // Runs `groups` workgroups (laid out in rows, see dispatchSize() in shared/dispatch.h).
    template <class Push>
    void dispatch(const Kernel& kernel, const Push& push, uint32_t groups) {
        static_assert(std::is_trivially_copyable_v<Push>);
        dispatchBytes(kernel, &push, sizeof(Push), groups);
    }
    // As many workgroups as the DispatchSize at `offset` in `sizes` says when the command runs.
    template <class Push>
    void dispatchIndirect(const Kernel& kernel, const Push& push, const Buffer& sizes, size_t offset) {
        static_assert(std::is_trivially_copyable_v<Push>);
        dispatchIndirectBytes(kernel, &push, sizeof(Push), sizes, offset);
    }
    void copy(VkBuffer from, size_t fromOffset, VkBuffer to, size_t toOffset, size_t bytes);
    void copy(const Buffer& from, const Buffer& to, size_t bytes) { copy(from.handle(), 0, to.handle(), 0, bytes); }
    void fillZero(const Buffer& buffer);

    // Runs what was recorded; the device's own time for it in milliseconds.
    double submit();
    // After submit(), of a recorder that times kernels: in the order in which they came first.
    const std::vector<KernelTime>& kernelTimes() const { return kernelTimes_; }

  private:
    Context& context_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkQueryPool times_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    const uint32_t timeCount_;          // entries of times_: begin, end, and one after each timed dispatch
    std::vector<const Kernel*> timed_;  // whose dispatch ended at entry 2 + i
    std::vector<KernelTime> kernelTimes_;

    void barrier();
    void noteEnd(const Kernel& kernel);
    double milliseconds(uint64_t from, uint64_t to) const;
    void sumTimes(const std::vector<uint64_t>& ticks);
    void bind(const Kernel& kernel, const void* push, size_t pushBytes);
    void dispatchBytes(const Kernel& kernel, const void* push, size_t pushBytes, uint32_t groups);
    void dispatchIndirectBytes(const Kernel& kernel, const void* push, size_t pushBytes, const Buffer& sizes,
                               size_t offset);
};

}  // namespace cleave
