// Records dispatches and copies into a command buffer that somebody else begins, ends and submits.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cassert>
#include <type_traits>

#include "cleave/cleave.hpp"
#include "record/kernel.h"
#include "shared/dispatch.h"

namespace cleave {

// Every command sees what the ones before it wrote.
class Recorder {
  public:
    // `row`: the most workgroups in a row (shared/dispatch.h).
    Recorder(const Functions& functions, VkCommandBuffer commands, uint32_t row = kLongestRow)
        : f_(functions), commands_(commands), row_(row) {}

    VkCommandBuffer commands() const { return commands_; }

    template <class Push>
    void dispatch(const Kernel& kernel, const Push& push, uint32_t groups) {
        dispatch(kernel, push, dispatchSize(groups, row_));
    }
    template <class Push>
    void dispatch(const Kernel& kernel, const Push& push, const DispatchSize& size) {
        bind(kernel, push);
        f_.CmdDispatch(commands_, size.x, size.y, size.z);
    }
    // As many workgroups as the DispatchSize at `offset` of `sizes` says when the command runs.
    template <class Push>
    void dispatchIndirect(const Kernel& kernel, const Push& push, VkBuffer sizes, VkDeviceSize offset) {
        bind(kernel, push);
        f_.CmdDispatchIndirect(commands_, sizes, offset);
    }

    // Any size; the bytes are copied while this records. `offset` and `bytes` are multiples of 4.
    void write(VkBuffer buffer, VkDeviceSize offset, const void* data, VkDeviceSize bytes);
    void fillZero(VkBuffer buffer, VkDeviceSize offset, VkDeviceSize bytes);
    // What was recorded before is done, and visible to what is recorded after.
    void barrier();

  private:
    const Functions& f_;
    VkCommandBuffer commands_;
    uint32_t row_;

    template <class Push>
    void bind(const Kernel& kernel, const Push& push) {
        static_assert(std::is_trivially_copyable_v<Push> && sizeof(Push) <= 128);
        assert(sizeof(Push) == kernel.pushBytes());
        barrier();
        f_.CmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, kernel.pipeline());
        f_.CmdPushConstants(commands_, kernel.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Push), &push);
    }
};

}  // namespace cleave
