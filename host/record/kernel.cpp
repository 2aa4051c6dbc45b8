#include "record/kernel.h"

#include <array>
#include <utility>

namespace cleave {
namespace {

constexpr uint32_t kMostConstants = 8;

VkResult createPipeline(const PipelineHome& home, VkShaderModule module, VkPipelineLayout layout,
                        std::span<const uint32_t> constants, VkPipeline* pipeline) {
    std::array<VkSpecializationMapEntry, kMostConstants> entries;
    for (uint32_t i = 0; i < constants.size(); i++)
        entries[i] = {i, static_cast<uint32_t>(i * sizeof(uint32_t)), sizeof(uint32_t)};
    const VkSpecializationInfo special{static_cast<uint32_t>(constants.size()), entries.data(), constants.size_bytes(),
                                       constants.data()};
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &special;
    info.layout = layout;
    return home.functions->CreateComputePipelines(home.device, home.cache, 1, &info, home.allocator, pipeline);
}

}  // namespace

Kernel::~Kernel() {
    if (!home_.functions) return;
    home_.functions->DestroyPipeline(home_.device, pipeline_, home_.allocator);
    home_.functions->DestroyPipelineLayout(home_.device, layout_, home_.allocator);
}

Kernel::Kernel(Kernel&& other) noexcept { *this = std::move(other); }

Kernel& Kernel::operator=(Kernel&& other) noexcept {
    std::swap(home_, other.home_);
    std::swap(name_, other.name_);
    std::swap(pushBytes_, other.pushBytes_);
    std::swap(layout_, other.layout_);
    std::swap(pipeline_, other.pipeline_);
    return *this;
}

VkResult Kernel::create(const PipelineHome& home, const Spirv& spirv, uint32_t pushBytes,
                        std::span<const uint32_t> constants) noexcept {
    if (spirv.words.empty() || constants.size() > kMostConstants) return VK_ERROR_INITIALIZATION_FAILED;
    Kernel made;
    made.home_ = home;
    made.name_ = spirv.name;
    made.pushBytes_ = pushBytes;
    const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, pushBytes};
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.pushConstantRangeCount = pushBytes > 0 ? 1 : 0;
    layout.pPushConstantRanges = &range;
    const Functions& f = *home.functions;
    VkResult result = f.CreatePipelineLayout(home.device, &layout, home.allocator, &made.layout_);
    if (result != VK_SUCCESS) return result;
    VkShaderModuleCreateInfo module{};
    module.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    module.codeSize = spirv.words.size_bytes();
    module.pCode = spirv.words.data();
    VkShaderModule shader = VK_NULL_HANDLE;
    result = f.CreateShaderModule(home.device, &module, home.allocator, &shader);
    if (result != VK_SUCCESS) return result;
    result = createPipeline(home, shader, made.layout_, constants, &made.pipeline_);
    f.DestroyShaderModule(home.device, shader, home.allocator);
    if (result == VK_SUCCESS) *this = std::move(made);
    return result;
}

}  // namespace cleave
