// The Vulkan instance, and the choice of a device.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gpu/owned.h"

namespace cleave {

struct DeviceInfo {
    uint32_t index = 0;
    std::string name;
    std::string type;  // "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
    std::string driver;
    std::string apiVersion;
    bool usable = false;
    bool chosen = false;      // what would be used where none is named
    std::string unusableWhy;  // what it lacks
};

// Hears what the validation layers say, one message a call.
using ValidationListener = std::function<void(const char* message)>;

// An instance; with a listener the validation layers (and synchronisation validation) are on.
class Instance {
  public:
    // `extensions`: what is enabled beside what validation needs; a window's surface. Throws Error if there is no
    // Vulkan loader or driver, or validation is wanted and not installed.
    explicit Instance(ValidationListener listener = nullptr, std::span<const char* const> extensions = {});

    VkInstance handle() const { return instance_.get(); }
    std::vector<VkPhysicalDevice> devices() const;

  private:
    static void destroyInstance(int, VkInstance instance, const VkAllocationCallbacks* allocator);
    static void destroyMessenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger,
                                 const VkAllocationCallbacks* allocator);

    std::unique_ptr<ValidationListener> listener_;  // its address is what the messenger knows
    Owned<int, VkInstance, destroyInstance> instance_;
    Owned<VkInstance, VkDebugUtilsMessengerEXT, destroyMessenger> messenger_;
};

// Every Vulkan device here, in the loader's order.
std::vector<DeviceInfo> listDevices();

DeviceInfo describe(VkPhysicalDevice device, uint32_t index);
// Index into `infos` of the best usable device, real GPUs before CPUs, or of the one that `nameOrIndex` names by its
// number or a part of its name (case is ignored). Throws Error.
uint32_t chooseDevice(const std::vector<DeviceInfo>& infos, const std::string& nameOrIndex);
// Family with compute and transfer; -1 if there is none.
int computeFamily(VkPhysicalDevice device);

}  // namespace cleave
