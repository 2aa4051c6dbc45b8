// The scene in the driver's own acceleration structures.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "shared/triangle.h"

namespace cleave {

// A function of an extension. Those that a device was opened with are there.
template <class Function>
Function extensionFunction(const Device& device, const char* name) {
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device.handle(), name));
}

// What the device tells of an extension, as the structure of that type.
template <class Properties>
Properties extensionProperties(const Device& device, VkStructureType type) {
    Properties asked{};
    asked.sType = type;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &asked;
    vkGetPhysicalDeviceProperties2(device.physicalDevice(), &properties);
    return asked;
}

inline uint64_t roundedUp(uint64_t value, uint64_t to) { return (value + to - 1) / to * to; }

// What was recorded before is done, and visible to all that comes after, on the host, too.
void waitForAll(VkCommandBuffer commands);

class AccelerationStructure;

// A bottom level with all triangles, opaque and two-sided, and a top level with one instance of it; both for fast rays.
class DriverScene {
  public:
    // At least one triangle; `numbers` says which of the world's they are, in the order that the driver gets them.
    DriverScene(Device& device, std::span<const Triangle> world, std::vector<uint32_t> numbers);
    ~DriverScene();

    double build();  // milliseconds on the device, without allocation
    // Of the top level, for shaders.
    uint64_t address() const;
    // The world's number of the triangle that the driver calls `index`.
    uint32_t number(uint32_t index) const { return numbers_[index]; }

  private:
    std::vector<uint32_t> numbers_;
    Buffer triangles_;
    Buffer instance_;
    Commands commands_;
    std::unique_ptr<AccelerationStructure> bottom_;
    std::unique_ptr<AccelerationStructure> top_;
};

}  // namespace cleave
