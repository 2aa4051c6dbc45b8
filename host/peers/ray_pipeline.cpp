#include "peers/ray_pipeline.h"

#include <algorithm>
#include <array>

#include "gpu/check.h"
#include "gpu/owned.h"
#include "peers/driver_peer.h"

namespace cleave {
namespace {

// The stages, each in a group of its own, in the order of the binding table.
struct Stage {
    const char* shader;
    VkShaderStageFlagBits stage;
};
constexpr std::array<Stage, 3> kStages = {{{"shoot", VK_SHADER_STAGE_RAYGEN_BIT_KHR},
                                           {"miss", VK_SHADER_STAGE_MISS_BIT_KHR},
                                           {"hit", VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR}}};
constexpr auto kStageCount = static_cast<uint32_t>(kStages.size());
constexpr VkShaderStageFlags kAllStages =
    VK_SHADER_STAGE_RAYGEN_BIT_KHR | VK_SHADER_STAGE_MISS_BIT_KHR | VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR;

using Module = Owned<VkDevice, VkShaderModule, vkDestroyShaderModule>;
using Layout = Owned<VkDevice, VkPipelineLayout, vkDestroyPipelineLayout>;
using Pipeline = Owned<VkDevice, VkPipeline, vkDestroyPipeline>;

Module moduleOf(VkDevice device, const char* name) {
    const Spirv spirv = findSpirv(peerKernels(), name);
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = spirv.words.size_bytes();
    info.pCode = spirv.words.data();
    Module module(device);
    check(vkCreateShaderModule(device, &info, nullptr, module.put()), std::string("loading shader ") + name);
    return module;
}

VkRayTracingShaderGroupCreateInfoKHR groupOf(uint32_t stage) {
    VkRayTracingShaderGroupCreateInfoKHR group{};
    group.sType = VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR;
    group.generalShader = group.closestHitShader = group.anyHitShader = group.intersectionShader = VK_SHADER_UNUSED_KHR;
    const bool hits = kStages[stage].stage == VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR;
    group.type =
        hits ? VK_RAY_TRACING_SHADER_GROUP_TYPE_TRIANGLES_HIT_GROUP_KHR : VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR;
    (hits ? group.closestHitShader : group.generalShader) = stage;
    return group;
}

Pipeline createPipeline(const Device& device, VkPipelineLayout layout, uint32_t anyHit) {
    const VkSpecializationMapEntry entry{0, 0, sizeof(anyHit)};
    const VkSpecializationInfo special{1, &entry, sizeof(anyHit), &anyHit};
    std::array<Module, kStageCount> modules;
    std::array<VkPipelineShaderStageCreateInfo, kStageCount> stages{};
    std::array<VkRayTracingShaderGroupCreateInfoKHR, kStageCount> groups{};
    for (uint32_t i = 0; i < kStageCount; ++i) {
        modules[i] = moduleOf(device.handle(), kStages[i].shader);
        stages[i].sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stages[i].stage = kStages[i].stage;
        stages[i].module = modules[i].get();
        stages[i].pName = "main";
        stages[i].pSpecializationInfo = &special;
        groups[i] = groupOf(i);
    }
    VkRayTracingPipelineCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR;
    info.stageCount = kStageCount;
    info.pStages = stages.data();
    info.groupCount = kStageCount;
    info.pGroups = groups.data();
    info.maxPipelineRayRecursionDepth = 1;
    info.layout = layout;
    Pipeline pipeline(device.handle());
    check(extensionFunction<PFN_vkCreateRayTracingPipelinesKHR>(device, "vkCreateRayTracingPipelinesKHR")(
              device.handle(), VK_NULL_HANDLE, device.pipelineCache(), 1, &info, nullptr, pipeline.put()),
          "creating the ray-tracing pipeline");
    return pipeline;
}

// Which shaders a launch runs: a handle per group, each where a region of the table may begin.
class BindingTable {
  public:
    BindingTable() = default;
    BindingTable(Device& device, VkPipeline pipeline) {
        const auto properties = extensionProperties<VkPhysicalDeviceRayTracingPipelinePropertiesKHR>(
            device, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR);
        const uint64_t base = properties.shaderGroupBaseAlignment, handle = properties.shaderGroupHandleSize;
        stride_ = roundedUp(handle, std::max<uint64_t>(base, properties.shaderGroupHandleAlignment));
        std::vector<char> handles(kStageCount * handle);
        check(
            extensionFunction<PFN_vkGetRayTracingShaderGroupHandlesKHR>(device, "vkGetRayTracingShaderGroupHandlesKHR")(
                device.handle(), pipeline, 0, kStageCount, handles.size(), handles.data()),
            "reading the handles of the ray-tracing pipeline");
        memory_ = Buffer(device, kStageCount * stride_ + base, VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR);
        first_ = roundedUp(memory_.address(), base);
        for (uint32_t i = 0; i < kStageCount; ++i)
            memory_.write(first_ - memory_.address() + i * stride_, &handles[i * handle], handle);
    }
    VkStridedDeviceAddressRegionKHR region(uint32_t stage) const {
        return {first_ + stage * stride_, stride_, stride_};
    }

  private:
    Buffer memory_;
    uint64_t first_ = 0;
    uint64_t stride_ = 0;
};

class RayPipeline : public DriverPeer {
  public:
    RayPipeline(Device& device, const PeerScene& scene, TriangleOrder order)
        : DriverPeer(device, scene, order), layout_(device.handle()) {
        const VkPushConstantRange range{kAllStages, 0, sizeof(PeerTracePush)};
        VkPipelineLayoutCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        info.pushConstantRangeCount = 1;
        info.pPushConstantRanges = &range;
        check(vkCreatePipelineLayout(device.handle(), &info, nullptr, layout_.put()), "creating a pipeline layout");
        traceRays_ = extensionFunction<PFN_vkCmdTraceRaysKHR>(device, "vkCmdTraceRaysKHR");
    }

  private:
    struct Variant {
        Pipeline pipeline;
        BindingTable table;
    };
    Layout layout_;
    std::array<Variant, 2> variants_;  // closest hits, any hits
    PFN_vkCmdTraceRaysKHR traceRays_ = nullptr;

    void prepare(Query query) override {
        const uint32_t anyHit = query == Query::any ? 1 : 0;
        Variant& variant = variants_[anyHit];
        if (variant.pipeline) return;
        variant.pipeline = createPipeline(device(), layout_.get(), anyHit);
        variant.table = BindingTable(device(), variant.pipeline.get());
    }

    void record(VkCommandBuffer commands, const PeerTracePush& push, Query query) override {
        const Variant& variant = variants_[query == Query::any ? 1 : 0];
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR, variant.pipeline.get());
        vkCmdPushConstants(commands, layout_.get(), kAllStages, 0, sizeof(push), &push);
        const VkStridedDeviceAddressRegionKHR shoot = variant.table.region(0), miss = variant.table.region(1),
                                              hit = variant.table.region(2), none{};
        traceRays_(commands, &shoot, &miss, &hit, &none, push.rayCount, 1, 1);
    }
};

}  // namespace

std::unique_ptr<Peer> makeRayPipeline(Device& device, const PeerScene& scene, TriangleOrder order) {
    return std::make_unique<RayPipeline>(device, scene, order);
}

}  // namespace cleave
