#include "gpu/kernel.h"

#include "base/stopwatch.h"
#include "gpu/spirv.h"

namespace cleave {

Kernel::Kernel(Context& context, const std::string& name, size_t pushBytes, std::vector<uint32_t> constants)
    : context_(context), name_(name), pushBytes_(pushBytes) {
    const Stopwatch watch;
    const std::span<const uint32_t> words = spirv(name);
    VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, static_cast<uint32_t>(pushBytes)};
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.pushConstantRangeCount = pushBytes > 0 ? 1 : 0;
    layout.pPushConstantRanges = &range;
    check(vkCreatePipelineLayout(context.device, &layout, nullptr, &layout_), "creating a pipeline layout");

    VkShaderModuleCreateInfo module{};
    module.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    module.codeSize = words.size_bytes();
    module.pCode = words.data();
    VkShaderModule shader = VK_NULL_HANDLE;
    check(vkCreateShaderModule(context.device, &module, nullptr, &shader), ("loading kernel " + name).c_str());

    std::vector<VkSpecializationMapEntry> entries;
    for (uint32_t i = 0; i < constants.size(); i++)
        entries.push_back({i, static_cast<uint32_t>(i * sizeof(uint32_t)), sizeof(uint32_t)});
    VkSpecializationInfo special{static_cast<uint32_t>(entries.size()), entries.data(),
                                 constants.size() * sizeof(uint32_t), constants.data()};
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &special;
    info.layout = layout_;
    const VkResult result =
        vkCreateComputePipelines(context.device, context.pipelineCache, 1, &info, nullptr, &pipeline_);
    vkDestroyShaderModule(context.device, shader, nullptr);
    check(result, ("creating the pipeline of kernel " + name).c_str());
    context.setupMs += watch.milliseconds();
}

Kernel::~Kernel() {
    vkDestroyPipeline(context_.device, pipeline_, nullptr);
    vkDestroyPipelineLayout(context_.device, layout_, nullptr);
}

}  // namespace cleave
