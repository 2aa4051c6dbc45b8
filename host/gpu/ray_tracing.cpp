#include "gpu/ray_tracing.h"

#include <algorithm>
#include <cstring>

#include "gpu/check.h"

namespace cleave {
namespace {

class Extensions {
  public:
    explicit Extensions(VkPhysicalDevice device) {
        uint32_t count = 0;
        check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr),
              "listing the device's extensions");
        all_.resize(count);
        check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, all_.data()),
              "listing the device's extensions");
        all_.resize(count);
    }
    bool has(const char* name) const {
        return std::any_of(all_.begin(), all_.end(), [name](const VkExtensionProperties& extension) {
            return std::strcmp(extension.extensionName, name) == 0;
        });
    }

  private:
    std::vector<VkExtensionProperties> all_;
};

}  // namespace

RayTracingRequest::RayTracingRequest(VkPhysicalDevice device) {
    structure_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR;
    query_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR;
    pipeline_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_FEATURES_KHR;
    const Extensions known(device);
    if (!known.has(VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME) ||
        !known.has(VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME))
        return;
    extensions_ = {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
    found_.query = known.has(VK_KHR_RAY_QUERY_EXTENSION_NAME);
    found_.pipeline = known.has(VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME);
    if (found_.query) extensions_.push_back(VK_KHR_RAY_QUERY_EXTENSION_NAME);
    if (found_.pipeline) extensions_.push_back(VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME);
    // An extension comes with the feature of its name: that is all that is used.
    structure_.accelerationStructure = VK_TRUE;
    query_.rayQuery = VK_TRUE;
    pipeline_.rayTracingPipeline = VK_TRUE;
}

void* RayTracingRequest::chain(void* next) {
    if (extensions_.empty()) return next;
    structure_.pNext = next;
    next = &structure_;
    if (found_.query) {
        query_.pNext = next;
        next = &query_;
    }
    if (found_.pipeline) {
        pipeline_.pNext = next;
        next = &pipeline_;
    }
    return next;
}

}  // namespace cleave
