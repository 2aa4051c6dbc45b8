// A compute pipeline.
#pragma once

#include <string>
#include <vector>

#include "gpu/device.h"

namespace cleave {

class Kernel {
  public:
    // `name` is the stem of a shader file; `constants` are its specialisation constants 0, 1, ...; pushBytes is the
    // size of its push constants.
    Kernel(Context& context, const std::string& name, size_t pushBytes, std::vector<uint32_t> constants = {});
    ~Kernel();
    Kernel(const Kernel&) = delete;
    Kernel& operator=(const Kernel&) = delete;

    VkPipeline pipeline() const { return pipeline_; }
    VkPipelineLayout layout() const { return layout_; }
    size_t pushBytes() const { return pushBytes_; }
    const std::string& name() const { return name_; }

  private:
    Context& context_;
    std::string name_;
    size_t pushBytes_ = 0;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace cleave
