#include "record/functions.h"

namespace cleave {

const char* Functions::load(PFN_vkGetInstanceProcAddr instanceFunction, VkInstance instance, VkDevice device) noexcept {
    if (!instanceFunction || !instance || !device) return "vkGetInstanceProcAddr";
    const auto deviceFunction =
        reinterpret_cast<PFN_vkGetDeviceProcAddr>(instanceFunction(instance, "vkGetDeviceProcAddr"));
    if (!deviceFunction) return "vkGetDeviceProcAddr";
#define CLEAVE_LOAD(name)                                                      \
    name = reinterpret_cast<PFN_vk##name>(deviceFunction(device, "vk" #name)); \
    if (!name) return "vk" #name;
    CLEAVE_DEVICE_FUNCTIONS(CLEAVE_LOAD)
#undef CLEAVE_LOAD
    return nullptr;
}

}  // namespace cleave
