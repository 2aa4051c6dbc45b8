#include "gpu/check.h"

#include "base/error.h"

namespace cleave {

void check(VkResult result, const std::string& what) {
    if (result == VK_SUCCESS) return;
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
        throw Error(what + ": the device is out of memory; set a memory budget or use a smaller scene");
    if (result == VK_ERROR_DEVICE_LOST) throw Error(what + ": the device was lost; try another device");
    throw Error(what + ": Vulkan error " + std::to_string(result));
}

}  // namespace cleave
