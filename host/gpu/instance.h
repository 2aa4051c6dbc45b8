// The Vulkan instance, and the choice of a device.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <vector>

#include "gpu/context.h"

namespace cleave {

struct ValidationLog;

// True where the environment asks for validation (CLEAVE_VALIDATION=1).
bool validationWanted();

// An instance, with validation and a messenger that feeds `log` where wanted. Throws Error.
VkInstance createInstance(ValidationLog* log, VkDebugUtilsMessengerEXT* messenger);
void destroyInstance(VkInstance instance, VkDebugUtilsMessengerEXT messenger);

std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance);
DeviceInfo describe(VkPhysicalDevice device, uint32_t index);
// Index into `infos` of the best usable device, or of the one that `nameOrIndex` names. Throws Error.
uint32_t chooseDevice(const std::vector<DeviceInfo>& infos, const std::string& nameOrIndex);
// Family with compute and transfer; -1 if there is none.
int computeFamily(VkPhysicalDevice device);

}  // namespace cleave
