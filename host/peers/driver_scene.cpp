#include "peers/driver_scene.h"

#include "gpu/check.h"

namespace cleave {
namespace {

constexpr VkBufferUsageFlags kInput = VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;

Buffer trianglesInOrder(Device& device, std::span<const Triangle> world, std::span<const uint32_t> numbers) {
    std::vector<Triangle> ordered;
    ordered.reserve(numbers.size());
    for (const uint32_t number : numbers) ordered.push_back(world[number]);
    Buffer buffer(device, ordered.size() * sizeof(Triangle), kInput);
    buffer.upload(std::span<const Triangle>(ordered));
    return buffer;
}

VkAccelerationStructureGeometryKHR triangleGeometry(uint64_t address, uint32_t count) {
    VkAccelerationStructureGeometryKHR geometry{};
    geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
    geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
    geometry.flags = VK_GEOMETRY_OPAQUE_BIT_KHR;
    VkAccelerationStructureGeometryTrianglesDataKHR& triangles = geometry.geometry.triangles;
    triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
    triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
    triangles.vertexData.deviceAddress = address;
    triangles.vertexStride = sizeof(vec3);
    triangles.maxVertex = 3 * count - 1;
    triangles.indexType = VK_INDEX_TYPE_NONE_KHR;
    return geometry;
}

VkAccelerationStructureGeometryKHR instanceGeometry(uint64_t address) {
    VkAccelerationStructureGeometryKHR geometry{};
    geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
    geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
    geometry.flags = VK_GEOMETRY_OPAQUE_BIT_KHR;
    geometry.geometry.instances.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
    geometry.geometry.instances.data.deviceAddress = address;
    return geometry;
}

VkAccelerationStructureInstanceKHR instanceOf(uint64_t bottom) {
    VkAccelerationStructureInstanceKHR instance{};
    for (int axis = 0; axis < 3; ++axis) instance.transform.matrix[axis][axis] = 1.0f;
    instance.mask = 0xFF;
    instance.flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR;
    instance.accelerationStructureReference = bottom;
    return instance;
}

}  // namespace

void waitForAll(VkCommandBuffer commands) {
    VkMemoryBarrier2 memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    memory.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    memory.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    memory.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT;
    memory.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &memory;
    vkCmdPipelineBarrier2(commands, &dependency);
}

// One level: its memory, and what building it takes.
class AccelerationStructure {
  public:
    AccelerationStructure(Device& device, VkAccelerationStructureTypeKHR type,
                          const VkAccelerationStructureGeometryKHR& geometry, uint32_t count)
        : device_(device), geometry_(geometry), range_{count, 0, 0, 0} {
        info_.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR;
        info_.type = type;
        info_.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
        info_.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
        info_.geometryCount = 1;
        info_.pGeometries = &geometry_;
        VkAccelerationStructureBuildSizesInfoKHR sizes{};
        sizes.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR;
        extensionFunction<PFN_vkGetAccelerationStructureBuildSizesKHR>(device,
                                                                       "vkGetAccelerationStructureBuildSizesKHR")(
            device.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info_, &count, &sizes);
        create(type, sizes.accelerationStructureSize);
        const uint64_t alignment = extensionProperties<VkPhysicalDeviceAccelerationStructurePropertiesKHR>(
                                       device, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR)
                                       .minAccelerationStructureScratchOffsetAlignment;
        scratch_ = Buffer(device, sizes.buildScratchSize + alignment);
        info_.scratchData.deviceAddress = roundedUp(scratch_.address(), alignment);
        build_ =
            extensionFunction<PFN_vkCmdBuildAccelerationStructuresKHR>(device, "vkCmdBuildAccelerationStructuresKHR");
    }
    ~AccelerationStructure() {
        extensionFunction<PFN_vkDestroyAccelerationStructureKHR>(device_, "vkDestroyAccelerationStructureKHR")(
            device_.handle(), info_.dstAccelerationStructure, nullptr);
    }
    AccelerationStructure(const AccelerationStructure&) = delete;
    AccelerationStructure& operator=(const AccelerationStructure&) = delete;

    void build(VkCommandBuffer commands) const {
        const VkAccelerationStructureBuildRangeInfoKHR* ranges = &range_;
        build_(commands, 1, &info_, &ranges);
        waitForAll(commands);
    }
    uint64_t address() const { return address_; }

  private:
    Device& device_;
    VkAccelerationStructureGeometryKHR geometry_;
    VkAccelerationStructureBuildGeometryInfoKHR info_{};
    VkAccelerationStructureBuildRangeInfoKHR range_;
    Buffer memory_;
    Buffer scratch_;
    uint64_t address_ = 0;
    PFN_vkCmdBuildAccelerationStructuresKHR build_ = nullptr;

    void create(VkAccelerationStructureTypeKHR type, uint64_t bytes) {
        memory_ = Buffer(device_, bytes, VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR);
        VkAccelerationStructureCreateInfoKHR made{};
        made.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR;
        made.buffer = memory_.handle();
        made.size = bytes;
        made.type = type;
        check(extensionFunction<PFN_vkCreateAccelerationStructureKHR>(device_, "vkCreateAccelerationStructureKHR")(
                  device_.handle(), &made, nullptr, &info_.dstAccelerationStructure),
              "creating an acceleration structure of the driver");
        VkAccelerationStructureDeviceAddressInfoKHR of{};
        of.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR;
        of.accelerationStructure = info_.dstAccelerationStructure;
        address_ = extensionFunction<PFN_vkGetAccelerationStructureDeviceAddressKHR>(
            device_, "vkGetAccelerationStructureDeviceAddressKHR")(device_.handle(), &of);
    }
};

DriverScene::DriverScene(Device& device, std::span<const Triangle> world, std::vector<uint32_t> numbers)
    : numbers_(std::move(numbers)),
      triangles_(trianglesInOrder(device, world, numbers_)),
      instance_(device, sizeof(VkAccelerationStructureInstanceKHR), kInput),
      commands_(device) {
    const auto count = static_cast<uint32_t>(numbers_.size());
    bottom_ = std::make_unique<AccelerationStructure>(device, VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR,
                                                      triangleGeometry(triangles_.address(), count), count);
    const VkAccelerationStructureInstanceKHR instance = instanceOf(bottom_->address());
    instance_.upload(std::span(&instance, 1));
    top_ = std::make_unique<AccelerationStructure>(device, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR,
                                                   instanceGeometry(instance_.address()), 1);
}
DriverScene::~DriverScene() = default;

double DriverScene::build() {
    commands_.begin();
    waitForAll(commands_.handle());
    bottom_->build(commands_.handle());
    top_->build(commands_.handle());
    commands_.run();
    return commands_.milliseconds();
}

uint64_t DriverScene::address() const { return top_->address(); }

}  // namespace cleave
