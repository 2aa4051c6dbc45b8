// A compute pipeline without descriptors: what a kernel needs comes by push constants and addresses.
#pragma once

#include <span>

#include "record/functions.h"
#include "record/spirv.h"

namespace cleave {

// Where pipelines are made. `functions` outlives them.
struct PipelineHome {
    const Functions* functions = nullptr;
    VkDevice device = VK_NULL_HANDLE;
    VkPipelineCache cache = VK_NULL_HANDLE;
    const VkAllocationCallbacks* allocator = nullptr;
};

class Kernel {
  public:
    Kernel() = default;
    ~Kernel();
    Kernel(Kernel&& other) noexcept;
    Kernel& operator=(Kernel&& other) noexcept;

    // `constants` are the specialisation constants 0, 1, ...; pushBytes is the size of the push constants. Where
    // creation fails nothing is left behind.
    VkResult create(const PipelineHome& home, const Spirv& spirv, uint32_t pushBytes,
                    std::span<const uint32_t> constants) noexcept;

    VkPipeline pipeline() const { return pipeline_; }
    VkPipelineLayout layout() const { return layout_; }
    uint32_t pushBytes() const { return pushBytes_; }
    std::string_view name() const { return name_; }

  private:
    PipelineHome home_;
    std::string_view name_;
    uint32_t pushBytes_ = 0;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace cleave
